#include "core/import/time_column.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/import/field_name.h"
#include "core/math/statistics.h"

namespace heft {

namespace {

/// How much a name speaks for a column of times; 0: nothing.
int rankOf(const FieldName& name, const std::string& lower) {
  if (lower == "%time") return 6;
  static constexpr std::array kOther = {"diff", "delta", "duration", "sync",  "execution", "cycle",
                                        "step", "date",  "offset",   "delay", "received",  "interval"};
  const auto is = [&](const char* word) {
    return std::find(name.words.begin(), name.words.end(), word) != name.words.end();
  };
  for (const char* const word : kOther)
    if (is(word)) return 0;
  const auto& words = name.words;
  const auto alone = [&](const char* word) { return words.size() == 1 && words[0] == word; };
  if (alone("time")) return 5;
  if (alone("timestamp") || alone("timestamps") || alone("stamp")) return 4;
  if (words.size() == 2 && words[0] == "time" && words[1] == "stamp") return 4;
  static constexpr std::array kAlone = {"t",     "zeit",   "zeitstempel", "uhrzeit", "elapsed",
                                        "clock", "ts",     "tm",          "temps",   "horodatage",
                                        "heure", "tiempo", "hora",        "tempo",   "datetime"};
  if (words.size() == 1 && std::find(kAlone.begin(), kAlone.end(), words[0]) != kAlone.end()) return 3;
  if (words.size() == 2 && words[0] == "zeit" && words[1] == "in" && !name.unit.empty()) return 3;  // "ZeitInSec"
  if (words.empty() && !name.unit.empty()) return 3;                                                // "secs", "ms"
  if (words.size() > 4) return 0;
  // "robot.timestamp", "header.stamp", "elapsed_time", "time_since_start"
  if (is("timestamp") || is("timestamps") || is("stamp")) return 2;
  if (!words.empty() && (words.front() == "time" || words.back() == "time" || words.back() == "t")) return 1;
  return 0;
}

bool isSeconds(const FieldName& name) { return unitSi(name.unit, Quantity::time) == 1.0; }
bool isParts(const FieldName& name) {
  const auto unit = unitSi(name.unit, Quantity::time);
  return unit && *unit < 1.0;
}

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return out;
}

std::optional<TimeColumn> findTime(const std::vector<std::string>& names, const TimeChoice& choice) {
  std::vector<FieldName> read;
  read.reserve(names.size());
  for (const auto& name : names) read.push_back(readFieldName(name));
  const auto partsOf = [&](std::size_t i) -> std::optional<std::size_t> {
    if (!isSeconds(read[i])) return std::nullopt;
    for (std::size_t k = 0; k < names.size(); ++k)
      if (k != i && read[k].words == read[i].words && isParts(read[k])) return k;
    return std::nullopt;
  };
  // libfranka writes its robot's clock in milliseconds under the bare name.
  const bool libfranka = std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return name == "O_T_EE[0]" || name == "success_rate" || name == "state.q[0]";
  });
  const auto columnAt = [&](std::size_t i) {
    TimeColumn out;
    out.index = i;
    auto unit = unitSi(read[i].unit, Quantity::time);
    const auto lower = lowerCase(names[i]);
    if (lower == "%time") unit = 1e-9;
    if (libfranka && (lower == "time" || lower == "duration")) unit = 1e-3;
    if (choice.unit > 0.0) unit = choice.unit;
    out.unit = unit.value_or(1.0);
    out.unitKnown = unit.has_value();
    out.fraction = partsOf(i);
    if (out.fraction) out.fractionUnit = *unitSi(read[*out.fraction].unit, Quantity::time);
    return out;
  };
  if (!choice.column.empty()) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == choice.column) return columnAt(i);
    const auto wished = wordsOf(choice.column);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (partsOf(i) && read[i].words == wished) return columnAt(i);
    return std::nullopt;
  }
  std::optional<std::size_t> best;
  int bestRank = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto lower = lowerCase(names[i]);
    const int rank = libfranka && lower == "duration" ? 1 : rankOf(read[i], lower);
    if (rank <= bestRank) continue;
    // The parts of a second are no clock by themselves.
    bool parts = false;
    for (std::size_t k = 0; k < names.size() && isParts(read[i]); ++k) parts = parts || partsOf(k) == i;
    if (parts) continue;
    bestRank = rank;
    best = i;
  }
  if (!best) return std::nullopt;
  return columnAt(*best);
}

double unitOfTimes(const std::vector<double>& times) {
  const auto first = std::find_if(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
  if (first == times.end()) return 1.0;
  if (*first > 1e17) return 1e-9;
  if (*first > 1e14) return 1e-6;
  if (*first > 1e11) return 1e-3;
  return 1.0;
}

bool risesLikeTime(const std::vector<double>& values) {
  constexpr std::size_t kFewest = 20;
  constexpr double kAlike = 0.5, kMostly = 0.95;  // of the median step; of the steps
  if (values.size() < kFewest) return false;
  std::vector<double> steps;
  steps.reserve(values.size() - 1);
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double step = values[k] - values[k - 1];
    if (!(step > 0.0) || !std::isfinite(step)) return false;
    steps.push_back(step);
  }
  if (std::all_of(steps.begin(), steps.end(), [](double step) { return step == 1.0; })) return false;
  const double usual = median(steps);
  const auto alike =
      std::count_if(steps.begin(), steps.end(), [&](double step) { return std::abs(step - usual) < kAlike * usual; });
  return static_cast<double>(alike) >= kMostly * static_cast<double>(steps.size());
}

std::vector<std::int64_t> timesOf(const std::vector<double>& clock, const std::vector<double>& parts,
                                  const TimeColumn& column) {
  bool split = parts.size() == clock.size() && !clock.empty();
  for (std::size_t k = 0; k < clock.size() && split; ++k) {
    if (!std::isfinite(clock[k]) || !std::isfinite(parts[k])) continue;
    split = clock[k] == std::floor(clock[k]) && parts[k] >= 0.0 && parts[k] * column.fractionUnit < 1.0;
  }
  std::vector<std::int64_t> out;
  out.reserve(clock.size());
  for (std::size_t k = 0; k < clock.size(); ++k) {
    // Stamps in seconds are exact enough: 2^-52 of today's epoch is 0.3 us.
    const auto whole = nanoseconds(clock[k] * column.unit);
    out.push_back(split && std::isfinite(parts[k]) ? soundStamp(whole + nanoseconds(parts[k] * column.fractionUnit))
                                                   : whole);
  }
  return out;
}

std::int64_t soundStamp(std::int64_t stamp) { return isSoundStamp(stamp) ? stamp : 0; }

std::int64_t nanoseconds(double seconds) {
  const double stamp = seconds * 1e9;
  return std::isfinite(stamp) && std::abs(stamp) < static_cast<double>(kLargestStamp) ? std::llround(stamp) : 0;
}

}  // namespace heft
