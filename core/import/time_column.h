#pragma once
// Which column of a table holds the time, and in which unit.
#include <optional>
#include <string>
#include <vector>

#include "core/import/streams.h"

namespace heft {

struct TimeColumn {
  std::size_t index = 0;
  double unit = 1.0;  ///< [s]
  bool unitKnown = false;
};

/// By name: time, __time, t (s), %time (ns, rostopic), time of libfranka (ms), time_ms, timestamp_ns and so on; or the
/// chosen one.
std::optional<TimeColumn> findTime(const std::vector<std::string>& names, const TimeChoice& choice);

/// Unit that makes absolute times lie in this century: 1, 1e-3, 1e-6 or 1e-9 s; 1 for times that count from a start.
double unitOfTimes(const std::vector<double>& times);

/// Lower case (ASCII).
std::string lowerCase(std::string_view text);

}  // namespace heft
