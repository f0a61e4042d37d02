#pragma once
// Painting over what Heft suggests.
#include <optional>
#include <vector>

#include "core/recording/recording.h"
#include "core/segmentation/segmentation.h"

namespace heft {

/// `marks` with [from, to] painted over: neighbouring marks are shortened, split or joined, so that none overlap and
/// all are in order. Without a label the stretch becomes Heft's own suggestion again.
std::vector<Mark> painted(const std::vector<Mark>& marks, double from, double to, std::optional<MarkLabel> label);

/// Segments as they look at once after painting, before the next estimate: the marks laid over them, `reason` in those
/// parts. Slivers under `least` [s] that painting leaves of a segment are given to its neighbour; neighbouring free
/// parts become one.
std::vector<Segment> withMarks(const std::vector<Segment>& segments, const std::vector<Mark>& marks,
                               const std::string& reason, double least = 1e-3);

}  // namespace heft
