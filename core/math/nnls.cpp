#include "core/math/nnls.h"
#include "core/math/linear_algebra.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace heft {

Eigen::VectorXd nonNegativeLeastSquares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  using Eigen::Index;
  const Index n = A.cols();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n), residual = b;
  std::vector<Index> passive;
  std::vector<bool> isPassive(static_cast<std::size_t>(n), false);
  const Eigen::VectorXd lengths = A.colwise().norm();
  const double tolerance = 1e-10 * std::max(b.norm(), std::numeric_limits<double>::min());
  for (Index round = 0; round < 20 * A.rows() + 20; ++round) {
    // The column that the residual leans on most, by angle: columns may have very unequal lengths.
    const Eigen::VectorXd slope = A.transpose() * residual;
    Index next = -1;
    double best = tolerance;
    for (Index j = 0; j < n; ++j)
      if (!isPassive[static_cast<std::size_t>(j)] && slope(j) > best * lengths(j)) {
        best = slope(j) / lengths(j);
        next = j;
      }
    if (next < 0 || static_cast<Index>(passive.size()) >= A.rows()) break;
    passive.push_back(next);
    isPassive[static_cast<std::size_t>(next)] = true;
    while (!passive.empty()) {
      const Eigen::MatrixXd P = A(Eigen::all, passive);
      const Eigen::VectorXd z = leastSquares(P, b).x;
      if (z.minCoeff() > 0.0) {
        for (std::size_t i = 0; i < passive.size(); ++i) x(passive[i]) = z(static_cast<Index>(i));
        break;
      }
      // As far towards z as nothing becomes negative; what arrives at zero leaves.
      double step = 1.0;
      for (std::size_t i = 0; i < passive.size(); ++i)
        if (const double at = x(passive[i]), to = z(static_cast<Index>(i)); to <= 0.0)
          step = std::min(step, at / (at - to));
      std::vector<Index> kept;
      for (std::size_t i = 0; i < passive.size(); ++i) {
        const Index j = passive[i];
        const double to = z(static_cast<Index>(i));
        const double value = x(j) + step * (to - x(j));
        const bool leaves = to <= 0.0 && value <= 1e-14 * std::max(1.0, std::abs(x(j)));
        x(j) = leaves ? 0.0 : value;
        isPassive[static_cast<std::size_t>(j)] = !leaves;
        if (!leaves) kept.push_back(j);
      }
      if (kept.size() == passive.size()) return x;  // rounding: no progress is possible
      passive = std::move(kept);
    }
    residual = b - A * x;
  }
  return x;
}

}  // namespace heft
