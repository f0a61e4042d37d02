#pragma once
// Which findings speak against the numbers of an estimate: one list for the trust, the window, reports and payload
// files.
#include <string_view>

#include "core/base/findings.h"

namespace heft {

/// The finding of this code says that the numbers may be off by more than their intervals say.
bool doubtsNumbers(Severity severity, std::string_view code);

}  // namespace heft
