#pragma once
// Joint trajectories.
#include "core/math/rigid.h"

namespace heft {

/// A smooth joint motion, sampled; between the samples quintic polynomials that meet in position, velocity and
/// acceleration.
struct JointMotion {
  VectorXd time;        ///< [s], rising, from 0
  MatrixXd q, dq, ddq;  ///< N x dof [rad], [rad/s], [rad/s2]
  Eigen::Index size() const { return time.size(); }
  double duration() const { return size() > 0 ? time(size() - 1) : 0.0; }  ///< Time of its end
  void at(double t, VectorXd& position, VectorXd& velocity, VectorXd& acceleration) const;
  /// The same motion with `factor` times the duration.
  JointMotion slower(double factor) const;
};

/// Straight from one posture to another, at rest at both, in `seconds`.
JointMotion straightMotion(const VectorXd& from, const VectorXd& to, double seconds);

}  // namespace heft
