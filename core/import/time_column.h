#pragma once
// Which column of a table or dataset of a file holds the time, and in which unit.
#include <optional>
#include <string>
#include <vector>

#include "core/import/streams.h"

namespace heft {

struct TimeColumn {
  std::size_t index = 0;
  double unit = 1.0;  ///< [s]
  bool unitKnown = false;
  std::optional<std::size_t> fraction;  ///< A second column that counts the parts of a second (sec and nanosec).
  double fractionUnit = 0.0;            ///< [s]
};

/// By name: time, timestamp, stamp, t and so on with any unit that a name can state (time_ms, "Time [us]",
/// timestamp_ns), %time (ns, rostopic), time of libfranka (ms); or seconds and their parts in two columns
/// (header.stamp.sec and header.stamp.nanosec, secs and nsecs). Or the one that the user chose: by its name, or by what
/// two halves have in common ("header.stamp").
std::optional<TimeColumn> findTime(const std::vector<std::string>& names, const TimeChoice& choice);

/// Seconds, milliseconds, microseconds or nanoseconds, by the size of the first finite time: today's epoch in each.
double unitOfTimes(const std::vector<double>& times);

/// The times [ns] of a column; 0 where there is none. With `parts` (empty otherwise) whole seconds and their parts are
/// put together, unless the parts are none: not from 0 to 1 s.
std::vector<std::int64_t> timesOf(const std::vector<double>& clock, const std::vector<double>& parts,
                                  const TimeColumn& column);

/// Whether values rise from row to row in steps that are mostly alike, as times do; row numbers do not count.
bool risesLikeTime(const std::vector<double>& values);

std::string lowerCase(std::string_view text);

}  // namespace heft
