#pragma once
// Least squares with unknowns that cannot be negative.
#include <Eigen/Dense>

namespace heft {

/// x >= 0 that minimises |A x - b|^2 (Lawson and Hanson 1974, algorithm NNLS). At most as many entries are above zero
/// as A has rows.
Eigen::VectorXd nonNegativeLeastSquares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace heft
