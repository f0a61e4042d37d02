#include "core/conventions/agreement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/linear_algebra.h"

namespace heft::conventions {

namespace {

/// Columns: payload (10), zero (6), then these.
constexpr Eigen::Index kRatio = 16, kTurn = 17, kAll = 20;

constexpr double kSure = 6.0;  ///< Standard deviations

}  // namespace

bool Agreement::turned() const {
  constexpr double kHardlyAvoided = 1.0 * std::numbers::pi / 180.0;  // [rad]; bends little
  return turn > kHardlyAvoided && turn > kSure * turnStd;
}

bool Agreement::ratioDisagrees() const {
  constexpr double kHardlyAvoided = 0.05;
  return std::abs(ratio - 1.0) > kHardlyAvoided && std::abs(ratio - 1.0) > kSure * ratioStd;
}

Agreement agreementOf(const Blocks& blocks, const Way& way, const Fit& fit) {
  const Eigen::Index K = blocks.size();
  const bool standing = blocks.rateHz <= 0.0;
  MatrixXd force, torque;
  readingsOf(blocks, way, force, torque);
  const Vector3d h = fit.x.segment<3>(1);
  // As fitted, not as read: noise in columns draws what is found towards zero.
  const MatrixXd made = fit.load.transpose();
  MatrixXd A = MatrixXd::Zero(6 * K, kAll);
  VectorXd y(6 * K), scale(6 * K);
  for (Eigen::Index c = 0; c < 3; ++c) {
    const auto i = static_cast<std::size_t>(c);
    auto F = A.middleRows(c * K, K), T = A.middleRows((3 + c) * K, K);
    F.leftCols<4>() = blocks.force[i];
    F.col(10 + c).setOnes();
    T.middleCols<9>(1) = blocks.torque[i];
    T.col(13 + c).setOnes();
    if (!standing) T.col(kRatio) = blocks.torque[i].leftCols<3>() * h;
    // (e x f)_c for e = the axes after c: e_j has component c of e_j x f = +-f_l.
    const Eigen::Index j = (c + 1) % 3, l = (c + 2) % 3;
    F.col(kTurn + j) = -made.col(l);
    F.col(kTurn + l) = made.col(j);
    T.col(kTurn + j) = -made.col(3 + l);
    T.col(kTurn + l) = made.col(3 + j);
    y.segment(c * K, K) = force.col(c);
    y.segment((3 + c) * K, K) = torque.col(c);
    scale.segment(c * K, K) = fit.weights.cwiseSqrt() / fit.force;
    scale.segment((3 + c) * K, K) = fit.weights.cwiseSqrt() / fit.torque;
  }
  A = scale.asDiagonal() * A;
  y = scale.cwiseProduct(y);
  const VectorXd norms = A.colwise().norm().transpose().cwiseMax(1e-12);
  A = A * norms.cwiseInverse().asDiagonal();
  // What the motion does not show stays near zero.
  constexpr double kHeld = 1e-10;
  const MatrixXd inverted = inverse(transposedProduct(A, A) + kHeld * MatrixXd::Identity(kAll, kAll));
  const VectorXd x = inverted * (A.transpose() * y);
  const VectorXd r = y - A * x;
  MatrixXd left(K, 6);
  for (Eigen::Index c = 0; c < 6; ++c) left.col(c) = r.segment(c * K, K);
  const double spread = r.squaredNorm() / std::max(1.0, static_cast<double>(6 * K - kAll));
  const double longer = standing ? 1.0 : std::max(lastingOf(left.leftCols<3>()), lastingOf(left.rightCols<3>()));
  const MatrixXd covariance =
      spread * longer * norms.cwiseInverse().asDiagonal() * inverted * norms.cwiseInverse().asDiagonal();
  const VectorXd found = x.cwiseQuotient(norms);
  Agreement out;
  if (!standing) {
    out.ratio = 1.0 + found(kRatio);
    out.ratioStd = std::sqrt(std::max(0.0, covariance(kRatio, kRatio)));
  }
  const Vector3d turn = found.segment<3>(kTurn);
  out.turn = turn.norm();
  // Some directions are known far better than others: the angle is as sure as its components together.
  const Matrix3d turnCovariance = covariance.block<3, 3>(kTurn, kTurn);
  const double sure = std::sqrt(std::max(0.0, turn.dot(Vector3d(solveSymmetric(turnCovariance, turn)))));
  out.turnStd = sure > 0.0 ? out.turn / sure : 0.0;
  return out;
}

}  // namespace heft::conventions
