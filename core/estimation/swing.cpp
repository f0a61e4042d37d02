#include "core/estimation/swing.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

constexpr int kUnknowns = 19;    // phi, biases, -m r
constexpr double kFarthest = 3;  // [m]
constexpr double kClear = 0.9;   // energy that may be left

/// Normal matrix of [phi, bias, lever | y] over the free blocks. The lever's columns are those of the first moment in
/// the force rows: alpha x r + omega x (omega x r).
MatrixXd normalOf(const WrenchRows& blocks, const std::vector<MarkLabel>& labels) {
  Vector6d scale;
  scale << Vector3d::Constant(10.0), Vector3d::Constant(100.0);
  MatrixXd N = MatrixXd::Zero(kUnknowns + 1, kUnknowns + 1);
  MatrixXd A(6, kUnknowns + 1);
  for (Eigen::Index k = 0; k < blocks.size(); ++k) {
    if (labels[static_cast<std::size_t>(k)] != MarkLabel::free) continue;
    const Regressor& Y = blocks.Y[static_cast<std::size_t>(k)];
    A.setZero();
    A.leftCols<10>() = Y;
    A.middleCols<6>(10).setIdentity();
    A.block<3, 3>(0, 16) = Y.block<3, 3>(0, 1);
    A.col(kUnknowns) = blocks.wrench.col(k);
    A = scale.asDiagonal() * A;
    N += A.transpose() * A;
  }
  return N;
}

/// Solves for the first `unknowns`; the energy that is left.
double solve(const MatrixXd& N, int unknowns, VectorXd& x) {
  MatrixXd H = N.topLeftCorner(unknowns, unknowns);
  H.diagonal().array() += 1e-6;
  // About one kilogram and metre: nothing tells the lever along the only axis that the wrist turns about.
  if (unknowns == kUnknowns) H.diagonal().tail<3>().array() += 1.0;
  const VectorXd g = N.col(kUnknowns).head(unknowns);
  x = solveSymmetric(H, g);
  return N(kUnknowns, kUnknowns) - 2.0 * x.dot(g) + x.dot(N.topLeftCorner(unknowns, unknowns) * x);
}

}  // namespace

std::optional<Vector3d> restingPoint(const WrenchRows& blocks, const std::vector<MarkLabel>& labels) {
  const MatrixXd N = normalOf(blocks, labels);
  VectorXd x;
  const double resting = solve(N, kUnknowns - 3, x);
  const double swinging = solve(N, kUnknowns, x);
  if (!(x(0) > 0.02) || swinging > kClear * resting) return std::nullopt;
  const Vector3d lever = x.tail<3>() / x(0);
  if (!(lever.norm() < kFarthest)) return std::nullopt;
  return Vector3d(-lever);
}

void addSwing(const Vector3d& p_SoQ_S, Motion& motion) {
  for (Eigen::Index k = 0; k < motion.size(); ++k)
    motion.specificForce.col(k) -= leverMatrix(motion.omega.col(k), motion.alpha.col(k)) * p_SoQ_S;
  if (motion.accelerometer) motion.accelerometer->p_SoI_S = p_SoQ_S;
}

}  // namespace heft
