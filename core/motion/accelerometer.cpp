#include "core/motion/accelerometer.h"

#include <cmath>

#include "core/math/linear_algebra.h"

namespace heft {

namespace {

constexpr double kLeastExplained = 0.5;  ///< Share of the variance
constexpr double kLeastTurn = 0.5;     ///< [m/s2] Deviation of the specific force about its mean: a tilt of 3 degrees.
constexpr int kTurns = 10;             ///< Of rotation and lever in turn; four leave the lever 3 mm off in the tests.
constexpr double kRateScale = 1.25;    ///< Rates that differ more in size are in degrees, or another body's.
constexpr double kForceFollows = 0.8;  ///< Share of the force's variance; less is another body, or touched.
constexpr double kAsWell = 1.5;        ///< Squares that gravity may leave unexplained, against the best rotation.
constexpr double kLeverDoubt = 0.3;  ///< [m] How far from S a tool carries an accelerometer; holds what nothing tells.

Eigen::Matrix3Xd aboutMean(const Eigen::Matrix3Xd& x) { return x.colwise() - x.rowwise().mean(); }

/// R with R from = to as nearly as can be; `product` is the sum of to from^T.
Matrix3d rotationBetween(const Matrix3d& product) {
  const Eigen::JacobiSVD<Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3d U = svd.matrixU();
  const Matrix3d& V = svd.matrixV();
  if ((U * V.transpose()).determinant() < 0.0) U.col(2) = -U.col(2);
  return U * V.transpose();
}

/// What the force says of the rotation: F = m R_SI (y - bias) + L d + bias', with d = m (c - p) for a centre of mass c
/// and an accelerometer at p, L = leverMatrix().
struct ToldByForce {
  Matrix3d product = Matrix3d::Zero();  ///< For rotationBetween(), in the units of the readings
  Matrix3d R_SI = Matrix3d::Identity();
  double left = 0.0;   ///< [m2/s4], over all rows
  double share = 0.0;  ///< Of the force's variance that the readings explain
};

std::optional<ToldByForce> askForce(const AccelerometerRows& rows) {
  const Eigen::Index K = rows.readings.cols();
  if (rows.force.cols() != K) return std::nullopt;
  const Eigen::Matrix3Xd y = aboutMean(rows.readings), F = aboutMean(rows.force);
  Eigen::Matrix3Xd lever(3, 3 * K);
  Matrix3d mean = Matrix3d::Zero();
  for (Eigen::Index k = 0; k < K; ++k) {
    lever.middleCols<3>(3 * k) = leverMatrix(rows.omega.col(k), rows.alpha.col(k));
    mean += lever.middleCols<3>(3 * k) / static_cast<double>(K);
  }
  for (Eigen::Index k = 0; k < K; ++k) lever.middleCols<3>(3 * k) -= mean;
  // A free map of the readings (nine numbers, by columns) beside d.
  MatrixXd H = MatrixXd::Zero(12, 12), B(3, 12);
  VectorXd g = VectorXd::Zero(12);
  for (Eigen::Index k = 0; k < K; ++k) {
    for (Eigen::Index c = 0; c < 3; ++c) B.middleCols<3>(3 * c) = y(c, k) * Matrix3d::Identity();
    B.rightCols<3>() = lever.middleCols<3>(3 * k);
    H += B.transpose() * B;
    g += B.transpose() * F.col(k);
  }
  H.diagonal().array() += 1e-9 * H.trace();
  const Vector3d d = solveSymmetric(H, g).tail<3>();
  Eigen::Matrix3Xd carried = F;
  for (Eigen::Index k = 0; k < K; ++k) carried.col(k) -= lever.middleCols<3>(3 * k) * d;
  ToldByForce out;
  out.product = carried * y.transpose();
  out.R_SI = rotationBetween(out.product);
  const Eigen::Matrix3Xd turned = out.R_SI * y;
  const double mass = turned.cwiseProduct(carried).sum() / y.squaredNorm();
  if (!(mass > 0.0)) return std::nullopt;
  out.product /= mass;
  const double left = (carried - mass * turned).squaredNorm();
  out.left = left / (mass * mass);
  out.share = 1.0 - left / std::max(carried.squaredNorm(), 1e-12);
  return out;
}

/// R_SI and the bias of readings y = R_SI^T s + bias. Readings and rates count by how well each follows.
void fitRotation(const AccelerometerRows& rows, const Eigen::Matrix3Xd& s, AccelerometerMount& mount) {
  const Eigen::Matrix3Xd felt = aboutMean(rows.readings), told = aboutMean(s);
  Matrix3d gravity = told * felt.transpose();
  mount.R_SI = rotationBetween(gravity);
  if (const auto force = askForce(rows); force && force->share > kForceFollows) {
    const double byGravity = (mount.R_SI * felt - told).squaredNorm();
    if ((force->R_SI * felt - told).squaredNorm() < kAsWell * byGravity && force->left > 0.0) {
      gravity += byGravity / force->left * force->product;
      mount.R_SI = rotationBetween(gravity);
      mount.explained = force->share;
    }
  }
  if (rows.rates.cols() == felt.cols()) {
    const Eigen::Matrix3Xd turning = aboutMean(rows.rates), turned = aboutMean(rows.omega);
    const double size = turning.norm(), expected = turned.norm();
    if (size < kRateScale * expected && expected < kRateScale * size) {
      const double byGravity = (mount.R_SI * felt - told).squaredNorm();
      const Matrix3d rotation = turned * turning.transpose();
      const double byRates = (rotationBetween(rotation) * turning - turned).squaredNorm();
      if (byRates > 0.0) mount.R_SI = rotationBetween(gravity + byGravity / byRates * rotation);
    }
  }
  mount.bias = rows.readings.rowwise().mean() - mount.R_SI.transpose() * s.rowwise().mean();
}

/// p_SoI_S of what the readings have beyond the specific force of S's origin.
Vector3d fitLever(const AccelerometerRows& rows, const Eigen::Matrix3Xd& left) {
  const double variance = left.squaredNorm() / static_cast<double>(left.size());
  Matrix3d H = Matrix3d::Identity() * variance / (kLeverDoubt * kLeverDoubt);
  Vector3d g = Vector3d::Zero();
  for (Eigen::Index k = 0; k < left.cols(); ++k) {
    const Matrix3d L = leverMatrix(rows.omega.col(k), rows.alpha.col(k));
    H += L.transpose() * L;
    g += L.transpose() * left.col(k);
  }
  return H.ldlt().solve(g);
}

}  // namespace

Matrix3d leverMatrix(const Vector3d& omega, const Vector3d& alpha) {
  return skew(alpha) + omega * omega.transpose() - omega.squaredNorm() * Matrix3d::Identity();
}

Eigen::Matrix3Xd AccelerometerMount::specificForce(const Eigen::Ref<const Eigen::Matrix3Xd>& readings) const {
  return R_SI * (readings.colwise() - bias);
}

std::optional<AccelerometerMount> mountOf(const AccelerometerRows& rows, bool lever) {
  const Eigen::Index K = rows.readings.cols();
  const Vector3d mean = rows.specificForce.rowwise().mean();
  if (K < 3 || !rows.readings.allFinite()) return std::nullopt;
  if ((rows.specificForce.colwise() - mean).squaredNorm() < kLeastTurn * kLeastTurn * static_cast<double>(K))
    return std::nullopt;
  AccelerometerMount mount;
  Eigen::Matrix3Xd moved = rows.specificForce;
  for (int turn = 0; turn < (lever ? kTurns : 1); ++turn) {
    fitRotation(rows, moved, mount);
    if (!lever) break;
    mount.p_SoI_S = fitLever(rows, mount.specificForce(rows.readings) - rows.specificForce);
    for (Eigen::Index k = 0; k < K; ++k)
      moved.col(k) = rows.specificForce.col(k) + leverMatrix(rows.omega.col(k), rows.alpha.col(k)) * mount.p_SoI_S;
  }
  const Eigen::Matrix3Xd left = mount.specificForce(rows.readings) - moved;
  const Vector3d meanOfReadings = rows.readings.rowwise().mean();
  mount.rms = std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
  mount.explained =
      std::max(mount.explained, 1.0 - left.squaredNorm() / (rows.readings.colwise() - meanOfReadings).squaredNorm());
  if (!(mount.explained > kLeastExplained)) return std::nullopt;
  return mount;
}

}  // namespace heft
