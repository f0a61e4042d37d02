#pragma once
// What the joints have to give for a motion, of the masses that the robot states and of what it carries.
#include <optional>

#include "core/robot/robot_model.h"

namespace heft {

/// What a link carries beside its own mass.
struct CarriedBody {
  int link = 0;
  BodyInertia body;
};

/// Whether a joint's limit can be compared with what the motion takes: some joint states an effort, and a link that
/// moves a mass.
bool statesTorques(const RobotModel& robot);

/// Torque [N m] or force [N] of each column of q, from Newton's and Euler's equations without friction and without what
/// turns inside the motors. `gravity` [m/s2] in base axes. Masses that the robot does not state count as none. Throws
/// std::invalid_argument like RobotModel::frameMotion.
VectorXd jointTorques(const RobotModel& robot, const Vector3d& gravity, const std::optional<CarriedBody>& carried,
                      const VectorXd& q, const VectorXd& dq, const VectorXd& ddq);

}  // namespace heft
