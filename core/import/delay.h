#pragma once
// How much later the wrench is than the motion, told by the force that follows it.
#include <optional>

#include "core/base/result.h"
#include "core/import/align.h"
#include "core/import/joining.h"
#include "core/import/signals.h"
#include "core/motion/motion.h"
#include "core/recording/recording.h"

namespace heft {

/// The sensor's specific force from the motion alone: joints, or where there are none the orientation. Nothing where
/// the robot is not known or the motion too short.
std::optional<Motion> specificForceOf(const Signal& joints, const Signal& quaternion, const RecordingMeta& meta,
                                      const std::string& file);

/// The specific force in the axes that the wrench comes in, by columns.
MatrixXd inWrenchAxes(const Motion& motion, const Conventions& conventions);

/// Of two signals on one clock: says by how much the force is late, where the data tell it. Nothing is shifted.
void tellDelay(const Motion& moved, const Conventions& conventions, const Signal& motion, const Signal& wrench,
               Joining& joining);

/// Of two signals on unrelated clocks: what to add to the wrench's times. `zeros` [s]: the motion's zero less the
/// wrench's, as the files count. An error where the data do not tell.
Result<OffsetEstimate> findClockOffset(const std::optional<Motion>& moved, const Conventions& conventions,
                                       const Signal& motion, const Signal& wrench, double zeros, Joining& joining);

}  // namespace heft
