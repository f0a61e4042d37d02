#pragma once
// What the user said about an instant of a recording.
#include <optional>

#include "core/recording/recording.h"

namespace heft {

/// The last of the meta's marks that covers `time` [s]; else the label column's cell at or before it; else nothing.
std::optional<MarkLabel> markedAt(const Recording& recording, double time);

}  // namespace heft
