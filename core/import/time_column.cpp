#include "core/import/time_column.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace heft {

namespace {

struct TimeName {
  const char* name;
  int rank;
  double unit;  ///< [s]; 0: not told by the name.
};

constexpr std::array<TimeName, 22> kTimeNames = {
    {{"%time", 5, 1e-9},  // rostopic echo -p
     {"time", 4, 0.0},          {"__time", 4, 0.0},        {"time_s", 4, 1.0},     {"time [s]", 4, 1.0},
     {"time (s)", 4, 1.0},      {"time_ms", 4, 1e-3},      {"time_msec", 4, 1e-3}, {"time [ms]", 4, 1e-3},
     {"time (ms)", 4, 1e-3},    {"time_us", 4, 1e-6},      {"time [us]", 4, 1e-6}, {"time_ns", 4, 1e-9},
     {"time [ns]", 4, 1e-9},    {"timestamp", 3, 0.0},     {"timestamps", 3, 0.0}, {"timestamp_ns", 3, 1e-9},
     {"timestamp_us", 3, 1e-6}, {"timestamp_ms", 3, 1e-3}, {"stamp", 3, 0.0},      {"t", 2, 0.0},
     {"secs", 2, 1.0}}};

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return out;
}

std::optional<TimeColumn> findTime(const std::vector<std::string>& names, const TimeChoice& choice) {
  if (!choice.column.empty()) {
    const auto found = std::find(names.begin(), names.end(), choice.column);
    if (found == names.end()) return std::nullopt;
    return TimeColumn{static_cast<std::size_t>(found - names.begin()), choice.unit > 0.0 ? choice.unit : 1.0,
                      choice.unit > 0.0};
  }
  // libfranka writes its robot's clock in milliseconds under the bare name.
  const bool libfranka = std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return name == "O_T_EE[0]" || name == "success_rate" || name == "state.q[0]";
  });
  std::optional<TimeColumn> best;
  int bestRank = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto name = lowerCase(names[i]);
    const auto known =
        std::find_if(kTimeNames.begin(), kTimeNames.end(), [&](const TimeName& each) { return name == each.name; });
    if (known == kTimeNames.end() || known->rank <= bestRank) continue;
    bestRank = known->rank;
    best = TimeColumn{i, known->unit > 0.0 ? known->unit : 1.0, known->unit > 0.0};
    if (libfranka && name == "time") *best = {i, 1e-3, true};
  }
  if (best && choice.unit > 0.0) {
    best->unit = choice.unit;
    best->unitKnown = true;
  }
  return best;
}

double unitOfTimes(const std::vector<double>& times) {
  const auto first = std::find_if(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
  if (first == times.end()) return 1.0;
  if (*first > 1e17) return 1e-9;
  if (*first > 1e14) return 1e-6;
  if (*first > 1e11) return 1e-3;
  return 1.0;
}

std::int64_t nanoseconds(double seconds) {
  return std::isfinite(seconds) && std::abs(seconds) < 9.2e9 ? std::llround(seconds * 1e9) : 0;
}

}  // namespace heft
