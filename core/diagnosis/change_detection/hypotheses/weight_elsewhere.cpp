// The tool weighs what it weighs elsewhere, but its weight sits at another place, the same each time, as where it has
// play in its holder.
#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

namespace heft::diagnosis {

std::optional<SegmentAnswer> weightElsewhere(const SegmentData& data) {
  const auto& load = data.load;
  if (!load || std::abs(load->mass) >= std::max(2.0 * load->massStd, kNoLoad * data.fit.model.x(6)))
    return std::nullopt;
  // Next to nothing, and clearly less than somebody does who holds on to the tool.
  return SegmentAnswer{heft::toSay("where in the tool its weight sits"), load->share, 3.0,
                       load->share < kSmallShare && load->shareOfHolding < kMajority};
}

}  // namespace heft::diagnosis
