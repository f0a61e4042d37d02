#pragma once
// The Newton-Euler wrench of a rigid payload, and its regressor: linear in the ten parameters.
#include "core/math/rigid.h"
#include "core/payload/inertial_parameters.h"

namespace heft {

/// Instant motion of S in S axes.
struct WrenchState {
  Vector3d specificForce = Vector3d::Zero();  ///< s = a - g, S axes [m/s2]
  Vector3d omega = Vector3d::Zero();          ///< [rad/s]
  Vector3d alpha = Vector3d::Zero();          ///< [rad/s2]
};

using Regressor = Eigen::Matrix<double, 6, 10>;

/// Y with F_PSo_S = Y phi: f = m s + alpha x h + omega x (omega x h), tau = I alpha + omega x I omega + h x s
/// (seed paper, Eq. 1, with -g for its +g; I about S's origin; phi as in inertial_parameters.h).
Regressor regressor(const WrenchState& state);

/// F_PSo_S computed directly from Newton-Euler about the centre of mass, independent of regressor().
Vector6d predictWrench(const Payload& payload, const WrenchState& state);

}  // namespace heft
