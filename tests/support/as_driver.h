#pragma once
// What drivers, controllers and users make of a plain recording: written in the world's terms, row by row, and
// independent of the module that has to find it out again.
#include <cstdint>
#include <string>
#include <vector>

#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft::test {

/// Names of what rewriteAs() knows, without "wall" and "ceiling", which are worlds and not drivers.
const std::vector<std::string>& driverNames();

/// Rewrites a plain recording (its joints, or poses, and its wrench) as the named driver or user would have written it.
/// Several names with "+" between them: one after the other.
void rewriteAs(const std::string& name, const RobotModel& robot, std::uint64_t seed, Recording& recording);

/// Poses of S in B in place of the joints, as a log of the tool frame has them.
void logPoses(const RobotModel& robot, Recording& recording);

/// `count` standing poses of a Panda that holds `payload` in random tilts; bias 3 N and 0.1 N m, noise 0.02 N and
/// 0.001 N m. `bias` 0: zeroed before.
Recording standingRecording(const Payload& payload, int count, const Vector3d& gravity, double bias,
                            std::uint64_t seed);

}  // namespace heft::test
