#pragma once
// The acceleration of a sensor whose position was not recorded.
#include <optional>

#include "core/motion/motion.h"
#include "core/recording/recording.h"
#include "core/wrench/rows.h"

namespace heft {

/// A wrist that turns swings the sensor about some point r away, a = -(alpha x r + omega x (omega x r)) with r constant
/// in S where one joint moves. Forces and torques together tell r from the payload's first moment, which alone also
/// turns with gravity. Returns p_SoQ_S [m], Q the point that stays at rest, if that explains the free blocks' wrench
/// clearly better than a resting origin (a tenth of the misfit's energy at least), else nothing. Along an axis that
/// it alone turns about, r is told by nothing, does nothing and stays near zero.
std::optional<Vector3d> restingPoint(const WrenchRows& blocks, const std::vector<MarkLabel>& labels);

/// Adds the acceleration that follows from the resting point to the specific force.
/// Of a motion whose specific force is an accelerometer's, Q is where that stands: the same equations tell it.
void addSwing(const Vector3d& p_SoQ_S, Motion& motion);

}  // namespace heft
