#include "core/estimation/triangle.h"

#include <array>
#include <cmath>

#include "core/math/four_rows.h"

namespace heft {

namespace {

struct Chunk {
  double* columns;
  Eigen::Index stride, rows;  ///< A multiple of eight

  double* column(Eigen::Index j) const { return columns + j * stride; }
};

/// Adds w v to column `c`; returns its square.
[[gnu::always_inline]] inline double reflect(const Chunk& chunk, const double* v, Eigen::Index c, double w) {
  double* const x = chunk.column(c);
  FourRows even{}, odd{};
  for (Eigen::Index k = 0; k < chunk.rows; k += 8) {
    const FourRows first = inMemory(x + k).rows + w * inMemory(v + k).rows,
                   second = inMemory(x + k + 4).rows + w * inMemory(v + k + 4).rows;
    inMemory(x + k).rows = first;
    inMemory(x + k + 4).rows = second;
    even += first * first;
    odd += second * second;
  }
  return sumOf(even + odd);
}

/// Adds w[i] v to `Count` columns from `c` on; `products` become those with `next`, another column.
template <int Count>
[[gnu::always_inline]] inline void reflectAndMultiply(const Chunk& chunk, const double* v, const double* next,
                                                      Eigen::Index c, const double* w, double* products) {
  double* const x = chunk.column(c);
  FourRows sum[Count];
  for (int i = 0; i < Count; ++i) sum[i] = FourRows{};
  for (Eigen::Index k = 0; k < chunk.rows; k += 4) {
    const FourRows ofV = inMemory(v + k).rows, ofNext = inMemory(next + k).rows;
    for (int i = 0; i < Count; ++i) {
      FourRowsInMemory& at = inMemory(x + i * chunk.stride + k);
      const FourRows moved = at.rows + w[i] * ofV;
      at.rows = moved;
      sum[i] += ofNext * moved;
    }
  }
  for (int i = 0; i < Count; ++i) products[i] = sumOf(sum[i]);
}

/// Below the triangle each column of [R; chunk] holds the chunk only, so that a reflector touches one row of R: H = I +
/// u u^T / (beta head) with u = [head; v]. Each pass over the chunk applies one reflector and multiplies with the next.
[[gnu::always_inline]] inline void addToTriangle(const Chunk& chunk, Triangle& R) {
  std::array<double, kColumns + 1> products{}, w{};
  // The first pass applies none.
  for (Eigen::Index j = -1; j <= kColumns; ++j) {
    const Eigen::Index after = j + 1;
    const double* const v = chunk.column(std::max<Eigen::Index>(j, 0));
    const double* const next = chunk.column(after);
    double below = reflect(chunk, v, after, w[static_cast<std::size_t>(after)]);
    Eigen::Index c = after + 1;
    for (; c + 4 <= kColumns + 1; c += 4) reflectAndMultiply<4>(chunk, v, next, c, w.data() + c, products.data() + c);
    for (; c <= kColumns; ++c) reflectAndMultiply<1>(chunk, v, next, c, w.data() + c, products.data() + c);
    w.fill(0.0);
    if (below > 0.0) {
      const double diagonal = R(after, after);
      const double norm = std::hypot(diagonal, std::sqrt(below));
      const double beta = diagonal > 0.0 ? -norm : norm, head = diagonal - beta;
      for (Eigen::Index i = after + 1; i <= kColumns; ++i) {
        double& factor = w[static_cast<std::size_t>(i)];
        factor = (products[static_cast<std::size_t>(i)] + head * R(after, i)) / (beta * head);
        R(after, i) += head * factor;
      }
      R(after, after) = beta;
    }
    if (after == kColumns) break;
  }
}

}  // namespace

void TriangleBuilder::compress() {
  const Eigen::Index rows = (filled_ + 7) / 8 * 8;
  static_assert(kChunk % 8 == 0);
  chunk_.middleRows(filled_, rows - filled_).setZero();
  const Chunk chunk{chunk_.data(), kChunk, rows};
  withFourRows([&]() __attribute__((always_inline)) { addToTriangle(chunk, R_); });
  filled_ = 0;
}

Triangle TriangleBuilder::finish() {
  compress();
  return R_;
}

Triangle merged(const std::vector<Triangle>& parts) {
  TriangleBuilder builder;
  for (const auto& part : parts) builder.add(part);
  return builder.finish();
}

Eigen::Matrix<double, 6, kColumns + 1> blockRows(const WrenchRows& rows, Eigen::Index k) {
  Eigen::Matrix<double, 6, kColumns + 1> A;
  A.leftCols<6>().setIdentity();
  A.middleCols<10>(6) = rows.Y[static_cast<std::size_t>(k)];
  A.col(kColumns) = rows.wrench.col(k);
  return A;
}

}  // namespace heft
