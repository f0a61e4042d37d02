#pragma once
// Free, approach, contact: a demonstration cut into the phases of a hybrid motion-force program.
#include "core/compensation/compensation.h"
#include "core/estimation/segment_recording.h"

namespace heft {

/// Neighbouring free segments are one phase. What comes right before a contact is its approach: back to where the tool
/// stood or turned away from the direction in which it touches, at most 1.5 s; where the position is not known, the
/// last 0.5 s of motion.
std::vector<PhaseSegment> phasesOf(const std::vector<Segment>& segments, const Motion& motion);

}  // namespace heft
