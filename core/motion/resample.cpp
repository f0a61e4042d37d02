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

/// The rows before and after an instant between `right` - 1 and `right`, and beyond each the next that is at least half
/// as far away as they are apart: slopes between close rows are mostly noise. None over a gap that is too long to be
/// bridged, or near an end of the recording.
std::optional<std::array<Eigen::Index, 4>> rowsAround(const VectorXd& time, Eigen::Index right) {
  constexpr double kLongest = 0.5;  // [s]
  const double apart = time(right) - time(right - 1);
  if (apart > kLongest) return std::nullopt;
  Eigen::Index before = right - 2, after = right + 1;
  while (before >= 0 && time(right - 1) - time(before) < 0.5 * apart) --before;
  while (after < time.size() && time(after) - time(right) < 0.5 * apart) ++after;
  if (before < 0 || after >= time.size()) return std::nullopt;
  return std::array<Eigen::Index, 4>{before, right - 1, right, after};
}

}  // namespace

Channels onGrid(const UniformGrid& grid, const VectorXd& time, const Eigen::Ref<const MatrixXd>& values,
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
    const auto rows = rowsAround(time, right);
    const double u = (t - left) / (time(right) - left);
    if (rows)
      interpolate(*rows, t, time, values, out.row(k - from));
    else
      out.row(k - from) = (1.0 - u) * values.row(right - 1) + u * values.row(right);
  }
  return out;
}

Channels onGrid(const UniformGrid& grid, const VectorXd& time, const Eigen::Ref<const MatrixXd>& values) {
  return onGrid(grid, time, values, 0, grid.size);
}

}  // namespace heft
