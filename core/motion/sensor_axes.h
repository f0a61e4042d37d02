#pragma once
// The part of the way to the plain form that takes the sensor's pose: see core/recording/conventions.h.
#include "core/base/result.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

/// Brings a wrench that was read in base axes or about the base's origin to S axes about S's origin; nothing happens to
/// one that is there. Where the recording has no poses, `robot` says from the joints where the sensor was; else it may
/// be null. Every program calls this where recording and robot are together for the first time.
Result<bool> toSensorAxes(Recording& recording, const RobotModel* robot);

/// The same with the robot that the recording's meta names, loaded only if it is needed.
Result<bool> toSensorAxes(Recording& recording);

}  // namespace heft
