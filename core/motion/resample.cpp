#include "core/motion/resample.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace heft {

UniformGrid gridFor(const VectorXd& time) {
  const Eigen::Index n = time.size();
  if (n < 2) throw std::invalid_argument("gridFor: at least two samples are needed");
  VectorXd steps = time.tail(n - 1) - time.head(n - 1);
  std::nth_element(steps.data(), steps.data() + (n - 1) / 2, steps.data() + n - 1);
  double step = steps((n - 1) / 2);
  const double span = time(n - 1) - time(0);
  UniformGrid grid;
  grid.start = time(0);
  grid.size = static_cast<Eigen::Index>(std::floor(span / step + 0.5)) + 1;
  // Rounded time stamps make the median step slightly wrong; the mean over the same number of steps is exact.
  if (grid.size == n) step = span / static_cast<double>(n - 1);
  grid.rateHz = 1.0 / step;
  grid.exact = grid.size == n;
  for (Eigen::Index i = 0; grid.exact && i < n; ++i)
    grid.exact = std::abs(time(i) - grid.start - static_cast<double>(i) * step) < 0.01 * step;
  return grid;
}

void interpolate(const std::array<Eigen::Index, 4>& rows, double t, const VectorXd& time,
                 const Eigen::Ref<const MatrixXd>& values, Row out) {
  out.setZero();
  for (const Eigen::Index i : rows) {
    double weight = 1.0;
    for (const Eigen::Index j : rows)
      if (j != i) weight *= (t - time(j)) / (time(i) - time(j));
    out += weight * values.row(i);
  }
}

namespace {

/// Rows that bridge the gap which ends at row `right`: its ends, and one as far away from each as it is long, since
/// slopes between close rows are mostly noise. None where it is too long to be bridged, or near an end of the
/// recording.
std::optional<std::array<Eigen::Index, 4>> bridge(const VectorXd& time, Eigen::Index right) {
  constexpr double kLongest = 0.5;  // [s]
  const double from = time(right - 1), to = time(right), away = to - from;
  if (away > kLongest || from - away < time(0) || to + away > time(time.size() - 1)) return std::nullopt;
  const double* first = time.data();
  return std::array<Eigen::Index, 4>{std::upper_bound(first, first + right, from - away) - first - 1, right - 1, right,
                                     std::lower_bound(first + right, first + time.size(), to + away) - first};
}

}  // namespace

Channels onGrid(const UniformGrid& grid, const VectorXd& time, const Eigen::Ref<const MatrixXd>& values, bool linear,
                Eigen::Index from, Eigen::Index to) {
  if (grid.exact) return values.middleRows(from, to - from);
  const Eigen::Index n = time.size();
  Channels out(to - from, values.cols());
  // First sample at or after t, at least 1
  Eigen::Index right =
      std::lower_bound(time.data(), time.data() + n, grid.start + static_cast<double>(from) / grid.rateHz) -
      time.data();
  right = std::clamp<Eigen::Index>(right, 1, n - 1);
  for (Eigen::Index k = from; k < to; ++k) {
    const double t = std::min(grid.start + static_cast<double>(k) / grid.rateHz, time(n - 1));
    while (right < n - 1 && time(right) < t) ++right;
    const double left = time(right - 1);
    const bool gap = time(right) - left > 3.0 / grid.rateHz;
    std::optional<std::array<Eigen::Index, 4>> rows;
    if (gap && !linear)
      rows = bridge(time, right);
    else if (!linear && right >= 2 && right <= n - 2)
      rows = {right - 2, right - 1, right, right + 1};
    const double u = (t - left) / (time(right) - left);
    if (rows)
      interpolate(*rows, t, time, values, out.row(k - from));
    else
      out.row(k - from) = (1.0 - u) * values.row(right - 1) + u * values.row(right);
  }
  return out;
}

Channels onGrid(const UniformGrid& grid, const VectorXd& time, const Eigen::Ref<const MatrixXd>& values, bool linear) {
  return onGrid(grid, time, values, linear, 0, grid.size);
}

}  // namespace heft
