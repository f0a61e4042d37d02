#pragma once
// What of a robot belongs to the sensor and the tool. Free of Qt and VTK.
#include <string>
#include <vector>

#include "ui/robot_look/robot_look.h"

namespace heft {

/// Links that the mount's parent carries, the sensor itself excepted: they move with the tool and are drawn as it.
std::vector<bool> linksBeyond(const RobotModel& robot, const std::string& mountLink);

/// Whether the robot's own shape has a sensor in it, which then need not be drawn a second time.
bool showsSensor(const RobotModel& robot, const RobotLook& look);

}  // namespace heft
