// A load that the tool carries for a while: a cause, looked for by itself once light touches are known as well.
#include "core/diagnosis/change_detection/carried_load.h"

#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

namespace heft::diagnosis {

std::optional<SegmentAnswer> carriedLoad(const SegmentData& data) {
  if (contains(data.fit.model, ids::payloadChange)) return std::nullopt;
  const auto load = loadIn(data.signals, data.fit, data.contacts);
  if (!load) return std::nullopt;
  return SegmentAnswer{{}, load->share, 4.0, isCarried(*load)};
}

}  // namespace heft::diagnosis
