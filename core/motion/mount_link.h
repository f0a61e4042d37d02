#pragma once
// Where the sensor sits on the robot.
#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

/// The number of the link that the mount names; an error that lists the links of a robot without it.
Result<int> mountLink(const SensorMount& mount, const RobotModel& robot);

/// Where nothing says where the sensor sits (the mount's parent is Panda's flange by default, which the robot does not
/// have), the robot's flange is taken: the link tool0, flange or ee_link behind its last moving joint, else that
/// joint's own link. A warning says so.
void mountOnFlange(RecordingMeta& meta, const RobotModel& robot, Findings& findings);

}  // namespace heft
