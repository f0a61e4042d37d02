// A load that the tool carries for a while: a cause, looked for by itself once light touches are known as well.
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

namespace heft::diagnosis {

std::optional<SegmentAnswer> carriedLoad(const SegmentData& data) {
  if (!data.load || contains(data.fit.model, ids::payloadChange)) return std::nullopt;
  return SegmentAnswer{{}, data.load->share, 4.0, isCarried(*data.load)};
}

}  // namespace heft::diagnosis
