#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/recording/checks.h"

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/recording/leaps.h"

namespace heft {

namespace {

constexpr double kGapSteps = 5.0;         ///< A step of more than this many medians is a gap.
constexpr Eigen::Index kMostPoses = 200;  ///< So few rows at one a second may be a slow motion.
constexpr double kSlowestMotion = 2.0;    ///< [s] A step above it is a wrong unit.
constexpr double kLowestRate = 50.0;      ///< [Hz] Below it accelerations of a hand-guided arm are lost.

std::string seconds(double value) {
  return value < 0.1 ? heft::say("{:.4g} ms", 1e3 * value) : heft::say("{:.4g} s", value);
}

/// Drops rows whose time does not exceed the time before; falling time fails.
std::optional<Error> makeRise(const Examined& examined) {
  const auto& time = examined.recording.time;
  const auto rows = time.size();
  const auto field = examined.map.time;
  std::vector<char> keep;
  Eigen::Index repeated = 0;
  Eigen::Index first = 0;
  double latest = time(0);
  for (Eigen::Index k = 1; k < rows; ++k) {
    if (time(k) > latest) {
      latest = time(k);
      continue;
    }
    if (time(k) < latest)
      return errorAt(examined.at(k, field), heft::say("time decreases from {} s to {} s.", latest, time(k)),
                     heft::say("Time must increase from row to row: split the file there if two recordings were "
                               "joined, or sort the rows."));
    if (repeated++ == 0) {
      first = k;
      keep.assign(static_cast<std::size_t>(rows), 1);
    }
    keep[static_cast<std::size_t>(k)] = 0;
  }
  if (repeated == 0) return std::nullopt;
  if (repeated == rows - 1)
    return errorAt(examined.at(1, field), heft::say("time stays at {} s in all {} rows.", time(0), rows),
                   heft::say("Write the time of each sample in seconds.") + " " + remedy(Remedy::sayStandingPoses));
  const double share = static_cast<double>(repeated) / static_cast<double>(rows);
  examined.note(Severity::warning, "time_repeated", examined.at(first, field),
                heft::say("{} of {} rows ({}) repeat the time of the row before and were left out.", repeated, rows,
                          percent(share)),
                share > 0.2 ? heft::say("The time seems to be written with too few digits.") : std::string());
  keepRows(examined.recording, examined.lines, keep);
  return std::nullopt;
}

std::optional<Error> checkSteps(const Examined& examined) {
  const auto& time = examined.recording.time;
  if (time.size() < 3) return std::nullopt;
  const VectorXd steps = time.tail(time.size() - 1) - time.head(time.size() - 1);
  VectorXd sorted = steps;
  const auto quantile = [&](double share) {
    const auto at = sorted.begin() + static_cast<Eigen::Index>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return *at;
  };
  const double median = quantile(0.5);
  const double low = quantile(0.05);
  const double high = quantile(0.95);
  const auto field = examined.map.time;

  // Nobody guides an arm for hours at one sample a second: such times are milliseconds or nanoseconds.
  const bool counted = low == 1.0 && high == 1.0 && time.size() > kMostPoses;
  if (counted)
    return errorAt(examined.at(1, field),
                   heft::say("the time increases by exactly 1 from row to row, like row numbers."),
                   remedy(Remedy::stateRate) + " " + remedy(Remedy::sayStandingPoses));
  if (median > kSlowestMotion || (median > 0.2 && time.size() > 1000))
    return errorAt(examined.at(1, field), heft::say("the time increases by {:.6g} s from row to row (median).", median),
                   (median >= 1e5   ? heft::say("Write time in seconds, not nanoseconds or microseconds.")
                    : median >= 1e3 ? heft::say("Write time in seconds, not microseconds.")
                                    : heft::say("Write time in seconds, not milliseconds.")) +
                       " " +
                       heft::say("Or state its unit in a map file: {}.",
                                 fmt::format(R"({{"scale": {{"time": {:g}}}}})", median >= 1e3 ? 1e-6 : 1e-3)) +
                       " " + remedy(Remedy::sayStandingPoses));
  if (median < 2e-5)
    examined.note(Severity::warning, "time_unit", examined.column(field),
                  heft::say("The rate would be {:.4g} Hz, more than wrist sensors give.", 1.0 / median),
                  heft::say("Check that time is in seconds."));
  if (median > 1.0 / kLowestRate * 1.001)
    examined.note(
        Severity::warning, "rate_low", examined.column(field),
        heft::say("The rate is {:.3g} Hz (median); inertia needs about 100 Hz or more.", 1.0 / median),
        heft::say("Mass and centre of mass can still be estimated; record at a higher rate for the inertia."));

  Eigen::Index gaps = 0;
  Eigen::Index longest = 0;
  double lost = 0.0;
  for (Eigen::Index k = 0; k < steps.size(); ++k) {
    if (steps(k) <= kGapSteps * median) continue;
    ++gaps;
    lost += steps(k);
    if (steps(k) > steps(longest)) longest = k;
  }
  if (gaps > 0) {
    examined.note(
        Severity::warning, "time_gap", examined.at(longest + 1, field),
        gaps == 1
            ? heft::say("{} gap in time, together {}; the longest is {} at {:.6g} s, where steps are {} (median).",
                        gaps, seconds(lost), seconds(steps(longest)), time(longest), seconds(median))
            : heft::say("{} gaps in time, together {}; the longest is {} at {:.6g} s, where steps are {} (median).",
                        gaps, seconds(lost), seconds(steps(longest)), time(longest), seconds(median)),
        steps(longest) > kGapLeftOut
            ? heft::say("Samples were lost there; gaps of more than {:.0f} ms are left out.", 1e3 * kGapLeftOut)
            : heft::say("Samples were lost there; the motion is interpolated across the gap."));
  }

  const double spread = (high - low) / median;
  if (spread > 0.1)
    examined.note(spread > 1.0 ? Severity::warning : Severity::info, spread > 1.0 ? "time_irregular" : "time_jitter",
                  examined.column(field),
                  heft::say("Time steps vary: nine in ten lie between {} and {}, median {} ({:.4g} Hz).", seconds(low),
                            seconds(high), seconds(median), 1.0 / median),
                  heft::say("The recording is resampled on a uniform clock."));
  return std::nullopt;
}

}  // namespace

std::optional<Error> checkTime(const Examined& examined) {
  auto& time = examined.recording.time;
  if (examined.recording.meta.kind == RecordingKind::poses) {
    bool rises = time.allFinite();
    for (Eigen::Index k = 1; k < time.size() && rises; ++k) rises = time(k) > time(k - 1);
    if (rises) return std::nullopt;
    time = VectorXd::LinSpaced(time.size(), 0.0, static_cast<double>(time.size() - 1));
    examined.note(
        Severity::info, "time_replaced", examined.column(examined.map.time),
        heft::say(
            "The time of the standing poses is missing or does not increase; they are numbered 0, 1, 2, ... instead."));
    return std::nullopt;
  }
  if (auto failure = makeRise(examined)) return failure;
  return checkSteps(examined);
}

}  // namespace heft
