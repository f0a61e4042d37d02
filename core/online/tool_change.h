#pragma once
// Contact or another tool? Another tool obeys a rigid body's equations for as long as it is there; a push does not.
#include <optional>

#include "core/online/block_learner.h"

namespace heft {

struct ToolChange {
  Eigen::Index from = 0;  ///< First block of the new tool
  double mass = 0.0;      ///< Rough [kg]
};

/// Looks at the newest two seconds: what the present tool cannot explain but another rigid body can, with the same
/// sensor bias and over more than one tilt, is another tool. Over four seconds and wider tilts the bias may be another
/// one too (a sensor that was tared).
std::optional<ToolChange> findToolChange(const LaneBlocks& blocks, const BlockLearner& present);

/// The block from which on `other` explains what `present` does not, at least one second of it.
std::optional<Eigen::Index> explainedSince(const LaneBlocks& blocks, const BlockLearner& present,
                                           const BlockLearner& other);

}  // namespace heft
