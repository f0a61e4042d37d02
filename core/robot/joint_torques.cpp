#include "core/robot/joint_torques.h"

#include <cmath>

namespace heft {

namespace {

/// Adds what one body on `link` takes.
void addTorques(const RobotModel& robot, const Vector3d& gravity, int link, const BodyInertia& body, const VectorXd& q,
                const VectorXd& dq, const VectorXd& ddq, VectorXd& torques) {
  Isometry3d X_LC = Isometry3d::Identity();
  X_LC.translation() = body.com;
  const FrameMotion motion = robot.frameMotion(link, X_LC, q, dq, ddq);
  const Matrix3d R = motion.X_BS.linear();
  const Matrix3d inertia = R * body.inertiaCom * R.transpose();
  const Vector3d& w = motion.w_BS_B;
  Vector6d wrench;
  wrench << body.mass * (motion.a_BSo_B - gravity), inertia * motion.alpha_BS_B + w.cross(inertia * w);
  torques.noalias() += robot.jacobian(link, X_LC, q).transpose() * wrench;
}

bool isMoved(const RobotModel& robot, int link) {
  while (link >= 0) {
    const int joint = robot.links()[static_cast<std::size_t>(link)].parentJoint;
    if (joint < 0) return false;
    if (robot.joints()[static_cast<std::size_t>(joint)].index >= 0) return true;
    link = robot.joints()[static_cast<std::size_t>(joint)].parentLink;
  }
  return false;
}

}  // namespace

bool statesTorques(const RobotModel& robot) {
  bool limited = false, heavy = false;
  for (int j = 0; j < robot.dof(); ++j) limited = limited || std::isfinite(robot.limits(j).effort);
  for (int i = 0; i < static_cast<int>(robot.links().size()); ++i)
    heavy = heavy || (robot.links()[static_cast<std::size_t>(i)].inertia && isMoved(robot, i));
  return limited && heavy;
}

VectorXd jointTorques(const RobotModel& robot, const Vector3d& gravity, const std::optional<CarriedBody>& carried,
                      const VectorXd& q, const VectorXd& dq, const VectorXd& ddq) {
  VectorXd torques = VectorXd::Zero(robot.dof());
  for (int i = 0; i < static_cast<int>(robot.links().size()); ++i)
    if (const auto& inertia = robot.links()[static_cast<std::size_t>(i)].inertia)
      addTorques(robot, gravity, i, *inertia, q, dq, ddq, torques);
  if (carried) addTorques(robot, gravity, carried->link, carried->body, q, dq, ddq, torques);
  return torques;
}

}  // namespace heft
