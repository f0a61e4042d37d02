#pragma once
// Dates and times of the day, as spreadsheets, loggers and databases write them.
#include <optional>
#include <string_view>

namespace heft {

/// Seconds since 1970 (UTC unless the text states a zone) of "2024-01-05 12:00:00.25", "2024-01-05T12:00:00Z",
/// "2024/01/05 12:00:00+01:00", "05.01.2024 12:00:00,25", "01/05/2024 1:00:00 PM" (month first, unless that is
/// impossible); seconds since midnight of "12:00:00.25"; seconds of "0.004 sec". Nothing for any other text, plain
/// numbers included.
std::optional<double> secondsOfDate(std::string_view text);

}  // namespace heft
