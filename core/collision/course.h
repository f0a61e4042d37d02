#pragma once
// How far the joints of a motion travel, bounded between its samples.
#include "core/robot/joint_motion.h"
#include "core/robot/robot_model.h"

namespace heft {

class Course {
 public:
  explicit Course(const JointMotion& motion);
  /// Joint angles at t [s].
  void at(double t, VectorXd& q) const;
  /// How far a point at most moves from the start until each sample: the sum over the joints of what they travel times
  /// `reach` [m/rad].
  VectorXd movedBy(const VectorXd& reach) const;
  /// The latest time at which a point has surely not moved farther than `distance` since t; beyond the end where it
  /// never does.
  double untilMoved(const VectorXd& moved, double t, double distance) const;

 private:
  const JointMotion& motion_;
  MatrixXd travelled_;  ///< N x dof, from the start [rad]
};

/// How far a joint's column moves a point of a body at most, per unit of it: 0 for joints that do not move the link.
/// `points`: 3 x K, link axes.
VectorXd jointReach(const RobotModel& robot, int link, const Eigen::Matrix3Xd& points);

/// Columns whose joints move both links, and so neither against the other.
std::vector<bool> sharedJoints(const RobotModel& robot, int first, int second);

/// Whether some joint brings the link nearer to a plane with this normal (base axes), or farther from it: an arm on a
/// table turns about the table's normal first.
bool changesHeight(const RobotModel& robot, int link, const Vector3d& normal);

}  // namespace heft
