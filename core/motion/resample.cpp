#include "core/motion/resample.h"

#include <algorithm>
#include <cmath>
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

Channels onGrid(const UniformGrid& grid, const VectorXd& time, const Eigen::Ref<const MatrixXd>& values, bool linear) {
  if (grid.exact) return values;
  const Eigen::Index n = time.size();
  Channels out(grid.size, values.cols());
  Eigen::Index right = 1;  // first sample at or after t, at least 1
  for (Eigen::Index k = 0; k < grid.size; ++k) {
    const double t = std::min(grid.start + static_cast<double>(k) / grid.rateHz, time(n - 1));
    while (right < n - 1 && time(right) < t) ++right;
    const double left = time(right - 1);
    const bool gap = time(right) - left > 3.0 / grid.rateHz;
    if (linear || gap || right < 2 || right > n - 2) {
      const double u = (t - left) / (time(right) - left);
      out.row(k) = (1.0 - u) * values.row(right - 1) + u * values.row(right);
      continue;
    }
    out.row(k).setZero();
    for (Eigen::Index i = right - 2; i <= right + 1; ++i) {
      double weight = 1.0;
      for (Eigen::Index j = right - 2; j <= right + 1; ++j)
        if (j != i) weight *= (t - time(j)) / (time(i) - time(j));
      out.row(k) += weight * values.row(i);
    }
  }
  return out;
}

}  // namespace heft
