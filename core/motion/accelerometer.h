#pragma once
// An accelerometer on the tool side as a witness of the motion: how it is mounted is found from what it reads.
#include <optional>

#include "core/math/rigid.h"

namespace heft {

/// The readings y of an accelerometer I that is fixed to S, after y = R_SI^T s_I + bias with
/// s_I = s_S + alpha x p + omega x (omega x p), s_S the specific force of S's origin and p = p_SoI_S.
struct AccelerometerMount {
  Matrix3d R_SI = Matrix3d::Identity();
  Vector3d p_SoI_S = Vector3d::Zero();  ///< [m]; zero where it was not asked for.
  Vector3d bias = Vector3d::Zero();     ///< [m/s2], in I axes
  double rms = 0.0;                     ///< [m/s2] What is left, per axis.
  double explained = 0.0;               ///< Share of the readings' variance that the motion explains; or of the
                                        ///< force's that the readings do, where that is more.

  /// s_I in S axes, of readings (3 x K).
  Eigen::Matrix3Xd specificForce(const Eigen::Ref<const Eigen::Matrix3Xd>& readings) const;
};

/// Columns are instants: what I reads (I axes), and s_S, omega and alpha (S axes) as the motion tells them.
struct AccelerometerRows {
  const Eigen::Matrix3Xd& readings;       ///< [m/s2]
  const Eigen::Matrix3Xd& specificForce;  ///< [m/s2]; -g_S alone where the origin's acceleration is not known.
  const Eigen::Matrix3Xd& omega;          ///< [rad/s]
  const Eigen::Matrix3Xd& alpha;          ///< [rad/s2]
  const Eigen::Matrix3Xd& rates;          ///< [rad/s] Of a gyroscope in I axes; no columns where there is none.
  const Eigen::Matrix3Xd& force;          ///< [N] On the payload, S axes; no columns where it is not to be asked.
};

/// The rotation by Wahba's problem (Markley 1988: one singular value decomposition), the lever by least squares in turn
/// with it where `lever`. Accelerations that the motion does not tell average out of the rotation, since a tool that
/// comes to rest was accelerated as much as slowed down. A gyroscope in rad/s tells the rotation, too, and so does the
/// force, which follows what the accelerometer feels: it counts where gravity does not speak against it. Nothing where
/// gravity hardly turns in S, or where the readings follow the motion by less than half of their variance: another
/// unit, another body, a wrong orientation.
std::optional<AccelerometerMount> mountOf(const AccelerometerRows& rows, bool lever);

/// alpha x p + omega x (omega x p) as a matrix that multiplies p.
Matrix3d leverMatrix(const Vector3d& omega, const Vector3d& alpha);

}  // namespace heft
