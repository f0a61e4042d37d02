#pragma once
// What an accelerometer adds to a motion, and what it has to say against it.
#include "core/motion/motion.h"

namespace heft {

/// `readings` [m/s2] and `rates` [rad/s] in I axes, a column an instant of the motion; rates may have none. Where the
/// acceleration of S's origin is not known, the specific force becomes the accelerometer's, and Motion::accelerometer
/// says how it is mounted; where it is known, the findings say whether the two agree.
void hearAccelerometer(const Eigen::Matrix3Xd& readings, const Eigen::Matrix3Xd& rates, Motion& motion);

}  // namespace heft
