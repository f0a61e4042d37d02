#pragma once
// Laws of how the tool or its joints move, that hold in all segments: each segment is told from the others.
#include <vector>

#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

namespace heft::diagnosis {

/// Whether each block tells of the law: all that are judged and the segments, or the segments alone, of a law that may
/// hold in a zone only.
std::vector<bool> everywhere(const SegmentData& data);
std::vector<bool> inSegments(const SegmentData& data);

/// Share of what is left of force, or of torque, in all segments that stays where what goes with `motion` (F x N) is
/// taken off, by the law that holds in all other places that are `known`.
double leftByLaw(const MatrixXd& motion, const SegmentData& data, const std::vector<bool>& known);

}  // namespace heft::diagnosis
