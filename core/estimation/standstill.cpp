#include "core/estimation/standstill.h"

#include <cmath>

namespace heft {

namespace {

constexpr double kTurning = 0.02;  // [rad/s]
constexpr double kChange = 0.2;    // [m/s2]
constexpr double kSpeedUp = 2.0;   // [rad/s2]

}  // namespace

bool standsStill(const Regressor& Y, const Vector3d& specificForce) {
  // f = m s + ([alpha]x + [omega]x^2) h: the antisymmetric part is alpha, the trace -2 |omega|^2.
  const Matrix3d M = Y.block<3, 3>(0, 1);
  const Vector3d alpha = 0.5 * Vector3d(M(2, 1) - M(1, 2), M(0, 2) - M(2, 0), M(1, 0) - M(0, 1));
  return std::sqrt(std::max(0.0, -0.5 * M.trace())) < kTurning && alpha.norm() < kSpeedUp &&
         (Vector3d(Y.block<3, 1>(0, 0)) - specificForce).norm() < kChange;
}

std::optional<Vector3d> stillness(const WrenchRows& rows, const std::vector<Run>& runs) {
  Vector3d mean = Vector3d::Zero();
  double count = 0.0;
  for (const auto& run : runs)
    for (Eigen::Index k = run.from; k < run.to; ++k, count += 1.0)
      mean += rows.Y[static_cast<std::size_t>(k)].block<3, 1>(0, 0);
  if (count == 0.0) return std::nullopt;
  mean /= count;
  for (const auto& run : runs)
    for (Eigen::Index k = run.from; k < run.to; ++k)
      if (!standsStill(rows.Y[static_cast<std::size_t>(k)], mean)) return std::nullopt;
  return mean;
}

Regressor regressorAtRest(const Vector3d& specificForce) {
  return regressor({specificForce, Vector3d::Zero(), Vector3d::Zero()});
}

}  // namespace heft
