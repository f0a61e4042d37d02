#pragma once
// How a stretch of time is written.
#include <string>

#include "core/base/say.h"

namespace heft {

/// "1.2 to 3.4 s"; with two digits where one would show the same number twice. [s]
inline std::string timeSpan(double from, double to) {
  if (fmt::format("{:.1f}", from) != fmt::format("{:.1f}", to)) return heft::say("{:.1f} to {:.1f} s", from, to);
  return heft::say("{:.2f} to {:.2f} s", from, to);
}

}  // namespace heft
