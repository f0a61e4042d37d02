#pragma once
// Where the sensor sits on the robot.
#include "core/base/result.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

/// The number of the link that the mount names; an error that lists the links of a robot without it.
Result<int> mountLink(const SensorMount& mount, const RobotModel& robot);

}  // namespace heft
