#include "core/math/column_products.h"

#include <algorithm>

#include "core/math/four_rows.h"

namespace heft {

namespace {

struct Columns {
  const double* first;
  Eigen::Index stride, count;

  const double* at(Eigen::Index j, Eigen::Index row) const { return first + j * stride + row; }
};

Columns columnsOf(const Eigen::Ref<const MatrixXd>& A) { return {A.data(), A.outerStride(), A.cols()}; }

/// Adds products of the rows [from, to) of P columns of A with Q of B.
template <int P, int Q>
[[gnu::always_inline]] inline void addTile(const Columns& A, Eigen::Index i, const Columns& B, Eigen::Index j,
                                           Eigen::Index from, Eigen::Index to, MatrixXd& out) {
  FourRows sum[P][Q];
  for (int p = 0; p < P; ++p)
    for (int q = 0; q < Q; ++q) sum[p][q] = FourRows{};
  const double *a[P], *b[Q];
  for (int p = 0; p < P; ++p) a[p] = A.at(i + p, 0);
  for (int q = 0; q < Q; ++q) b[q] = B.at(j + q, 0);
  Eigen::Index k = from;
  for (; k + 4 <= to; k += 4) {
    FourRows ofA[P];
    for (int p = 0; p < P; ++p) ofA[p] = inMemory(a[p] + k).rows;
    for (int q = 0; q < Q; ++q) {
      const FourRows ofB = inMemory(b[q] + k).rows;
      for (int p = 0; p < P; ++p) sum[p][q] += ofA[p] * ofB;
    }
  }
  for (int p = 0; p < P; ++p)
    for (int q = 0; q < Q; ++q) {
      double rest = 0.0;
      for (Eigen::Index last = k; last < to; ++last) rest += a[p][last] * b[q][last];
      out(i + p, j + q) += sumOf(sum[p][q]) + rest;
    }
}

template <int Q>
[[gnu::always_inline]] inline void addStrip(const Columns& A, Eigen::Index i, const Columns& B, Eigen::Index j,
                                            Eigen::Index from, Eigen::Index to, MatrixXd& out) {
  for (; i + 2 <= A.count; i += 2) addTile<2, Q>(A, i, B, j, from, to, out);
  if (i < A.count) addTile<1, Q>(A, i, B, j, from, to, out);
}

/// `symmetric`: A is B, and what lies above the diagonal is left out.
[[gnu::always_inline]] inline void addAll(const Columns& A, const Columns& B, Eigen::Index rows, bool symmetric,
                                          MatrixXd& out) {
  constexpr Eigen::Index kChunk = 256;  // 2 KB of a column: a strip of eight stays in the first cache
  for (Eigen::Index from = 0; from < rows; from += kChunk) {
    const Eigen::Index to = std::min(rows, from + kChunk);
    Eigen::Index j = 0;
    for (; j + 4 <= B.count; j += 4) addStrip<4>(A, symmetric ? j : 0, B, j, from, to, out);
    for (; j < B.count; ++j) addStrip<1>(A, symmetric ? j : 0, B, j, from, to, out);
  }
}

/// Adds `Count` columns to the rows [from, to) of `out`.
template <int Count>
[[gnu::always_inline]] inline void addColumns(const double* const* columns, const double* times, Eigen::Index from,
                                              Eigen::Index to, double* out) {
  Eigen::Index k = from;
  for (; k + 4 <= to; k += 4) {
    FourRows sum = inMemory(out + k).rows;
    for (int i = 0; i < Count; ++i) sum += times[i] * inMemory(columns[i] + k).rows;
    inMemory(out + k).rows = sum;
  }
  for (; k < to; ++k)
    for (int i = 0; i < Count; ++i) out[k] += times[i] * columns[i][k];
}

[[gnu::always_inline]] inline void sumAll(std::span<const double* const> columns, std::span<const double> times,
                                          Eigen::Index rows, double* out) {
  constexpr Eigen::Index kChunk = 1024;  // 8 KB of the sum stay in the first cache
  for (Eigen::Index from = 0; from < rows; from += kChunk) {
    const Eigen::Index to = std::min(rows, from + kChunk);
    std::fill(out + from, out + to, 0.0);
    std::size_t i = 0;
    for (; i + 4 <= columns.size(); i += 4) addColumns<4>(columns.data() + i, times.data() + i, from, to, out);
    for (; i < columns.size(); ++i) addColumns<1>(columns.data() + i, times.data() + i, from, to, out);
  }
}

/// Products of `x` with itself, `lag` and `Count` - 1 more rows later.
template <int Count>
[[gnu::always_inline]] inline void addLags(const double* x, Eigen::Index rows, Eigen::Index lag, double* sums) {
  FourRows sum[Count];
  for (int i = 0; i < Count; ++i) sum[i] = FourRows{};
  Eigen::Index k = 0;
  for (; k + 4 + lag + Count - 1 <= rows; k += 4) {
    const FourRows now = inMemory(x + k).rows;
    for (int i = 0; i < Count; ++i) sum[i] += now * inMemory(x + k + lag + i).rows;
  }
  for (int i = 0; i < Count; ++i) {
    double rest = 0.0;
    for (Eigen::Index last = k; last + lag + i < rows; ++last) rest += x[last] * x[last + lag + i];
    sums[i] += sumOf(sum[i]) + rest;
  }
}

[[gnu::always_inline]] inline void addAllLags(const double* x, Eigen::Index rows, Eigen::Index count, double* sums) {
  constexpr int kTogether = 9;  // Of an autoregression of order 8
  Eigen::Index lag = 0;
  for (; lag + kTogether <= count; lag += kTogether) addLags<kTogether>(x, rows, lag, sums + lag);
  for (; lag < count; ++lag) addLags<1>(x, rows, lag, sums + lag);
}

}  // namespace

MatrixXd columnProducts(const Eigen::Ref<const MatrixXd>& A, const Eigen::Ref<const MatrixXd>& B) {
  MatrixXd out = MatrixXd::Zero(A.cols(), B.cols());
  withFourRows([&]() __attribute__((always_inline)) { addAll(columnsOf(A), columnsOf(B), A.rows(), false, out); });
  return out;
}

MatrixXd columnProducts(const Eigen::Ref<const MatrixXd>& A) {
  MatrixXd out = MatrixXd::Zero(A.cols(), A.cols());
  withFourRows([&]() __attribute__((always_inline)) { addAll(columnsOf(A), columnsOf(A), A.rows(), true, out); });
  out.triangularView<Eigen::StrictlyUpper>() = out.transpose();
  return out;
}

void sumOfColumns(std::span<const double* const> columns, std::span<const double> times, VectorXd& out) {
  withFourRows([&]() __attribute__((always_inline)) { sumAll(columns, times, out.size(), out.data()); });
}

void addLaggedProducts(const Eigen::Ref<const VectorXd>& x, VectorXd& sums) {
  withFourRows([&]() __attribute__((always_inline)) { addAllLags(x.data(), x.size(), sums.size(), sums.data()); });
}

}  // namespace heft
