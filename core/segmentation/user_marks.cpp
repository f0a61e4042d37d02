#include "core/segmentation/user_marks.h"

#include <algorithm>

namespace heft {

std::optional<MarkLabel> markedAt(const Recording& recording, double time) {
  std::optional<MarkLabel> label;
  for (const auto& mark : recording.meta.marks)
    if (time >= mark.from && time <= mark.to) label = mark.label;
  if (label || recording.labels.empty()) return label;
  const double* begin = recording.time.data();
  const double* end = begin + recording.time.size();
  const auto index = std::max<std::ptrdiff_t>(0, std::upper_bound(begin, end, time) - begin - 1);
  return recording.labels[static_cast<std::size_t>(index)];
}

}  // namespace heft
