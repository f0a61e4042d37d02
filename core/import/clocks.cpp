#include "core/import/clocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/math/statistics.h"

namespace heft {

namespace {

constexpr double kSameClock = 0.5;  ///< [s] Delays from stamp to recorder that differ less belong to one clock.
constexpr std::int64_t kRestart = 500'000'000;  ///< [ns] Samples that come late are late by less.

double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

void Clocks::choose() {
  clockShift_.assign(joining_.streams.size(), 0);
  useStamps_.assign(joining_.streams.size(), false);
  if (joining_.wishes.clock == "received") return;
  std::vector<std::pair<std::size_t, double>> delays;
  bool allStamped = true;
  for (const auto s : joining_.used) {
    const auto& stream = joining_.streams[s];
    std::vector<double> delay;
    const bool stamped = isStamped(stream);
    allStamped = allStamped && stamped;
    if (!stamped) continue;
    for (std::size_t k = 0; k < stream.stamps.size(); ++k)
      delay.push_back(1e-9 * static_cast<double>(stream.received[k] - stream.stamps[k]));
    delays.emplace_back(s, quantile(std::move(delay), 0.05));
  }
  if (!allStamped) {
    if (!delays.empty())
      joining_.note(Severity::info, "clock_received",
                    heft::say("Not every topic stamps its messages, so the recorder's times are used for all."));
    return;
  }
  for (const auto& [s, delay] : delays) useStamps_[s] = true;
  const auto [least, most] = std::minmax_element(delays.begin(), delays.end(),
                                                 [](const auto& a, const auto& b) { return a.second < b.second; });
  if (joining_.wishes.clock == "header" || most->second - least->second < kSameClock) return;
  for (const auto& [s, delay] : delays) {
    clockShift_[s] = nanoseconds(delay);
    joining_.note(
        Severity::warning, "clock_shifted",
        heft::say(
            "The time stamps of {} are on another clock: {:.4f} s were added, based on when its messages arrived.",
            joining_.nameOf(s), delay),
        heft::say("The transport's delay is not known.") + " " + joining_.howToShift(s, 0.0));
  }
}

bool Clocks::isStamped(const Stream& stream) {
  if (stream.stamps.empty() || stream.stamps.size() != stream.received.size() ||
      std::any_of(stream.stamps.begin(), stream.stamps.end(), [](auto t) { return t == 0; }))
    return false;
  const auto [first, last] = std::minmax_element(stream.stamps.begin(), stream.stamps.end());
  return *last > *first;
}

std::optional<Error> Clocks::checkOffsets() const {
  for (const auto& offset : joining_.wishes.offset) {
    const std::string& name = offset.first;
    const bool known = std::any_of(joining_.streams.begin(), joining_.streams.end(), [&](const Stream& stream) {
      return name == stream.name || name == stream.file ||
             name == std::filesystem::path(stream.file).filename().string();
    });
    if (known) continue;
    std::vector<std::string> names;
    for (const auto s : joining_.used) names.push_back(joining_.nameOf(s));
    return errorAt({joining_.file, 0, 0},
                   heft::say("an offset is stated for \"{}\", which is not there.", printable(name)),
                   heft::say("What was chosen is {}.", fmt::join(names, ", ")));
  }
  return std::nullopt;
}

std::optional<Error> Clocks::refuseRestarts() {
  for (const auto s : joining_.used) {
    const auto& stream = joining_.streams[s];
    if (useStamps_[s] && restartsAt(s, stream.stamps) && !restartsAt(s, stream.received)) {
      for (const auto each : joining_.used) {
        useStamps_[each] = false;
        clockShift_[each] = 0;
      }
      joining_.note(Severity::warning, "clock_restarts",
                    heft::say("The time stamps of {} restart in the middle; the recorder's times are used for all.",
                              joining_.nameOf(s)));
    }
  }
  for (const auto s : joining_.used) {
    const auto& stream = joining_.streams[s];
    const auto& times = useStamps_[s] ? stream.stamps : stream.received;
    const auto at = restartsAt(s, times);
    if (!at) continue;
    return errorAt({stream.file, 0, 0},
                   heft::say("the times of {} decrease from {:.4f} s to {:.4f} s at sample {}, overlapping earlier "
                             "samples: two recordings, or two clocks.",
                             joining_.nameOf(s), 1e-9 * static_cast<double>(times[*at - 1]),
                             1e-9 * static_cast<double>(times[*at]), *at + 1),
                   heft::say("Split the recording there, or record one source only."));
  }
  return std::nullopt;
}

std::optional<std::size_t> Clocks::restartsAt(std::size_t s, const std::vector<std::int64_t>& times) const {
  std::optional<std::size_t> fall;
  for (std::size_t k = 1; k < times.size() && !fall; ++k)
    if (times[k - 1] - times[k] > kRestart) fall = k;
  if (!fall) return std::nullopt;
  std::vector<double> steps;
  for (std::size_t k = 1; k < times.size(); ++k)
    if (times[k] > times[k - 1]) steps.push_back(static_cast<double>(times[k] - times[k - 1]));
  if (steps.empty()) return fall;
  const double usual = median(std::move(steps));
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
  const auto core = joining_.coreOf(s);
  std::size_t crowded = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto a = order[i - 1], b = order[i];
    if (static_cast<double>(times[b] - times[a]) >= 0.75 * usual) continue;
    const bool twice = times[a] == times[b] && std::all_of(core.begin(), core.end(), [&](const auto* values) {
                         return a < values->size() && b < values->size() && (*values)[a] == (*values)[b];
                       });
    crowded += twice ? 0 : 1;
  }
  if (20 * crowded < order.size()) return std::nullopt;
  return fall;
}

std::optional<double> Clocks::statedOffset(std::size_t s) const {
  const auto& stream = joining_.streams[s];
  for (const auto& [name, seconds] : joining_.wishes.offset)
    if (name == stream.name || name == stream.file || name == std::filesystem::path(stream.file).filename().string())
      return seconds;
  return std::nullopt;
}

std::int64_t Clocks::offsetOf(std::size_t s) const { return nanoseconds(statedOffset(s).value_or(0.0)); }

bool Clocks::anyShift() const {
  return std::ranges::any_of(clockShift_, [](auto shift) { return shift != 0; });
}

bool Clocks::admit(std::size_t s, bool stamps) {
  if (stamps && !isStamped(joining_.streams[s])) return false;
  useStamps_[s] = stamps;
  return true;
}

}  // namespace heft
