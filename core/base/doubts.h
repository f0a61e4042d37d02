#pragma once
// Which findings speak against the numbers of an estimate: one list for the trust, the window, reports and payload
// files.
#include <string_view>

#include "core/base/findings.h"

namespace heft {

/// Kinds of numbers, as a sum.
enum Numbers : unsigned { kNoNumber = 0, kMass = 1, kCentre = 2, kInertia = 4, kAllNumbers = 7 };

/// Which numbers may be off by more than their intervals say, as the finding of this code has it.
unsigned doubtedBy(Severity severity, std::string_view code);
inline bool doubtsNumbers(Severity severity, std::string_view code) { return doubtedBy(severity, code) != kNoNumber; }

}  // namespace heft
