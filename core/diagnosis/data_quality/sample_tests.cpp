#include "core/diagnosis/data_quality/sample_tests.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/data_quality/clipping.h"
#include "core/diagnosis/data_quality/coarse_motion.h"
#include "core/diagnosis/data_quality/reported_velocities.h"
#include "core/estimation/spikes.h"
#include "core/math/statistics.h"
#include "core/recording/channels.h"

namespace heft::diagnosis {

namespace {

/// Rows at a value that a channel does not pass. Those that are lost are not to be trusted.
std::optional<Direct> saturation(const Recording& recording, const std::vector<FlatTop>& tops,
                                 const std::vector<bool>& lost) {
  if (tops.empty()) return std::nullopt;
  Direct out;
  out.cause = ids::saturation;
  std::vector<bool> clipped(lost.size(), false);
  for (const FlatTop& flat : tops) {
    out.parameters.push_back(
        {fmt::format("level_{}", channelName(flat.channel)), flat.channel < 3 ? "N" : "N m", flat.level, 0.0});
    for (const auto& [from, to] : flat.runs) std::fill(clipped.begin() + from, clipped.begin() + to, true);
  }
  const auto count = static_cast<double>(std::count(clipped.begin(), clipped.end(), true));
  out.parameters.push_back({"share", "%", 100.0 * count / static_cast<double>(recording.rows()), 0.0});
  out.rows = lost;
  return out;
}

/// Of the rows in which `cleaned` differs from `raw`, those in which one channel leaps far and no other leaps with it:
/// a knock or a jerk of the arm is felt by several.
Eigen::Index loneSpikes(const WrenchSamples& raw, const WrenchSamples& cleaned) {
  std::array<double, 6> noise{};
  for (std::size_t c = 0; c < 6; ++c) {
    const auto y = raw.col(static_cast<Eigen::Index>(c));
    std::vector<double> steps;
    for (Eigen::Index i = 1; i < y.size(); ++i)
      if (y(i) != y(i - 1)) steps.push_back(std::abs(y(i) - y(i - 1)));
    noise[c] = steps.empty() ? 0.0 : 1.4826 / std::numbers::sqrt2 * median(std::move(steps));
  }
  Eigen::Index out = 0;
  for (Eigen::Index i = 1; i + 1 < raw.rows(); ++i) {
    if (raw.row(i) == cleaned.row(i)) continue;
    int far = 0, felt = 0;
    for (Eigen::Index c = 0; c < 6; ++c) {
      const double usual = noise[static_cast<std::size_t>(c)],
                   off = std::abs(raw(i, c) - 0.5 * (cleaned(i - 1, c) + cleaned(i + 1, c)));
      far += off > kFarOut * usual ? 1 : 0;
      felt += off > kStandsOut * usual ? 1 : 0;
    }
    out += far == 1 && felt == 1 ? 1 : 0;
  }
  return out;
}

/// A few leaps that several channels share are no spikes. Of 100 recordings whose arm jerked now and then, the most had
/// 0.08 % of all rows; with spikes, 20 had 0.12 % and more.
std::optional<Direct> spikes(const RowFacts& facts, Eigen::Index rows) {
  constexpr double kFew = 0.1;  // [%]
  const double share = 100.0 * static_cast<double>(facts.spikes) / static_cast<double>(rows);
  if (facts.spikes < 3 || (share < kFew && facts.loneSpikes == 0)) return std::nullopt;
  Direct out;
  out.cause = ids::spikes;
  out.parameters = {{"count", "", static_cast<double>(facts.spikes), 0.0}, {"share", "%", share, 0.0}};
  return out;
}

/// Readings that only take values a few steps apart, so coarse that they stand still while the load changes.
std::optional<Direct> quantisation(const Vector6d& steps) {
  Direct out;
  const double force = steps.head<3>().maxCoeff(), torque = steps.tail<3>().maxCoeff();
  if (force > 0.0) out.parameters.push_back({"step_force", "N", force, 0.0});
  if (torque > 0.0) out.parameters.push_back({"step_torque", "N m", torque, 0.0});
  if (out.parameters.empty()) return std::nullopt;
  out.cause = ids::quantisation;
  return out;
}

/// Angles or poses from which no acceleration can be worked out as it was.
std::optional<Direct> coarse(const Recording& recording) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const auto motion = coarseMotion(recording);
  if (!motion) return std::nullopt;
  Direct out;
  out.cause = ids::derivativeNoise;
  if (motion->every > 0.0) out.parameters.push_back({"line", "ms", 1e3 * motion->every, 0.0});
  if (motion->stepAngle > 0.0) out.parameters.push_back({"step_angle", "deg", kDegrees * motion->stepAngle, 0.0});
  if (motion->stepPlace > 0.0) out.parameters.push_back({"step_place", "mm", 1e3 * motion->stepPlace, 0.0});
  return out;
}

Direct jitter(const UnevenStamps& stamps) {
  Direct out;
  out.cause = ids::jitter;
  out.parameters = {{"spread", "ms", 1e3 * stamps.spread, 0.0}};
  return out;
}

/// Readings that were held, zeroed or left out. Rows that are held for long are not to be trusted.
std::optional<Direct> dropouts(const Recording& recording, const RowFacts& facts) {
  const Eigen::Index n = recording.rows();
  Eigen::Index held = 0, zeros = 0, missing = 0, replayed = 0, motionHeld = 0;
  for (const auto& [from, to] : facts.stale) held += to - from;
  for (const Replay& replay : facts.replayed) replayed += replay.at.length();
  for (const auto& [from, to] : facts.motionHeld) motionHeld += to - from;
  const auto blanks = zeroRuns(recording);
  for (const auto& [from, to] : blanks) zeros += to - from;
  const double step = !facts.stamps && recording.rateHz() > 0.0 ? 1.0 / recording.rateHz() : 0.0;
  for (Eigen::Index i = 1; i < n && step > 0.0; ++i) {
    const double gap = (recording.time(i) - recording.time(i - 1)) / step;
    if (gap > 1.7) missing += static_cast<Eigen::Index>(std::lround(gap)) - 1;
  }
  const double total = static_cast<double>(n);
  const double lost = static_cast<double>(held + missing) / total;
  const double blank = static_cast<double>(zeros) / total;
  if (lost < 0.002 && blank < 0.0005 && facts.replayed.empty() && facts.motionHeld.size() < kAgainAndAgain)
    return std::nullopt;
  Direct out;
  out.cause = ids::dropouts;
  out.parameters = {{"repeated", "%", 100.0 * static_cast<double>(held) / total, 0.0},
                    {"zero", "%", 100.0 * blank, 0.0},
                    {"missing", "%", 100.0 * static_cast<double>(missing) / total, 0.0}};
  if (replayed > 0) out.parameters.push_back({"replayed", "%", 100.0 * static_cast<double>(replayed) / total, 0.0});
  if (motionHeld > 0)
    out.parameters.push_back({"motion_repeated", "%", 100.0 * static_cast<double>(motionHeld) / total, 0.0});
  out.rows.assign(static_cast<std::size_t>(n), false);
  for (const auto& [from, to] : blanks)
    if (recording.time(to - 1) - recording.time(from) > kShortestGap)
      std::fill(out.rows.begin() + from, out.rows.begin() + to, true);
  for (const Replay& replay : facts.replayed) {
    std::fill(out.rows.begin() + replay.at.from, out.rows.begin() + replay.at.to, true);
    out.when.emplace_back(recording.time(replay.at.from), recording.time(replay.at.to - 1));
  }
  // Where the motion was held, too, or nothing was recorded, its derivatives are wrong a little further.
  const auto beside = static_cast<Eigen::Index>(kMoment * recording.rateHz());
  for (Eigen::Index i = 1; i < n && step > 0.0; ++i)
    if (recording.time(i) - recording.time(i - 1) > std::max(kShortestGap, 3.0 * step))
      std::fill(out.rows.begin() + std::max<Eigen::Index>(0, i - beside), out.rows.begin() + std::min(n, i + beside),
                true);
  for (const Held& run : facts.held) {
    const Eigen::Index margin = run.motionToo ? beside : 0;
    std::fill(out.rows.begin() + std::max<Eigen::Index>(0, run.from - margin),
              out.rows.begin() + std::min(n, run.to + margin), true);
  }
  return out;
}

}  // namespace

RowFacts rowFactsOf(const Recording& recording) {
  RowFacts out;
  out.stamps = unevenStamps(recording);
  stopPoint();
  out.tops = flatTops(recording.wrench);
  stopPoint();
  out.deadBands = deadBands(recording);
  stopPoint();
  out.coarse = coarseReadings(recording);
  stopPoint();
  out.held = heldRows(recording);
  stopPoint();
  out.stale = staleRuns(recording);
  stopPoint();
  out.replayed = replayedStretches(recording.wrench, kFewestSamples);
  stopPoint();
  out.motionHeld = motionHolds(recording);
  stopPoint();
  const WrenchSamples raw = withoutZeros(recording, out.deadBands);
  const WrenchSamples cleaned = withoutSpikes(raw, out.spikes);
  if (out.spikes > 0) out.loneSpikes = loneSpikes(raw, cleaned);
  Unclipped clipping = unclipped(cleaned, out.tops, recording.rateHz());
  out.lost = std::move(clipping.lost);
  stopPoint();
  out.restored = std::move(clipping.wrench);
  stopPoint();
  spreadWithinSteps(recording, out.coarse, out.restored);
  return out;
}

std::vector<Direct> sampleTests(const Recording& recording, const Motion& motion, const RowFacts& facts) {
  std::vector<Direct> out;
  if (auto found = saturation(recording, facts.tops, facts.lost)) out.push_back(std::move(*found));
  if (facts.stamps) out.push_back(jitter(*facts.stamps));
  stopPoint();
  if (auto found = dropouts(recording, facts)) out.push_back(std::move(*found));
  if (auto found = quantisation(facts.coarse.steps)) out.push_back(std::move(*found));
  if (auto found = spikes(facts, recording.rows())) out.push_back(std::move(*found));
  stopPoint();
  const auto rough = coarse(recording);
  stopPoint();
  for (auto& found : reportedVelocities(recording, motion)) {
    // What does not agree with coarse positions may well be right.
    if (!rough) out.push_back(std::move(found));
  }
  if (rough) out.push_back(*rough);
  return out;
}

}  // namespace heft::diagnosis
