#pragma once
// Which stretches of a demonstration touched nothing.
#include <string>
#include <vector>

#include "core/recording/recording.h"
#include "core/wrench/rows.h"

namespace heft {

struct Segment {
  double from = 0, to = 0;  ///< [s]
  MarkLabel label = MarkLabel::free;
  std::string reason;       ///< In plain words.
};

enum class SegmentMode { automatic, marks, all };

/// The label of each block by what the user marked (meta marks, then the label column) and, in automatic mode, by how
/// far a rigid payload explains it. Marks always win. `rows` must not be averaged over more than 50 ms.
///
/// Automatic: a fit whose cost is capped in windows of 0.2 s finds the payload and bias that explain most of the motion,
/// however much of it is contact; blocks whose residual stays far above that fit's own scatter for longer than a spike are
/// contact, and the fit is repeated without them.
std::vector<MarkLabel> labelBlocks(const Recording& recording, const WrenchRows& rows, SegmentMode mode);

/// Runs of equal labels as segments, with a reason.
std::vector<Segment> segmentsOf(const Recording& recording, const WrenchRows& rows,
                                const std::vector<MarkLabel>& labels, SegmentMode mode);

/// Marks if the recording has any, otherwise automatic.
SegmentMode defaultSegmentMode(const Recording& recording);

}  // namespace heft
