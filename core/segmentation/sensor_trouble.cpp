#include "core/segmentation/sensor_trouble.h"

#include <algorithm>
#include <array>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/math/statistics.h"
#include "core/recording/frozen.h"
#include "core/recording/leaps.h"
#include "core/recording/replayed.h"

namespace heft {

namespace {

std::string nameOf(Eigen::Index channel) {
  static constexpr const char* kNames[] = {heft::toSay("Force x"),  heft::toSay("Force y"),  heft::toSay("Force z"),
                                           heft::toSay("Torque x"), heft::toSay("Torque y"), heft::toSay("Torque z")};
  return heft::say(fmt::runtime(kNames[channel]));
}

/// Near its limit a noisy channel is at it in some rows and below it in others; it is cut off in all of them.
std::vector<FrozenStretch> cutStretches(const FlatTop& flat, const VectorXd& time) {
  constexpr double kBetween = 0.04;           // [s]
  constexpr Eigen::Index kFewestAtLevel = 3;  // Rows at the level: one or two are there by chance
  std::vector<FrozenStretch> out;
  Eigen::Index atLevel = 0;
  const auto close = [&] {
    if (!out.empty() && atLevel < kFewestAtLevel) out.pop_back();
    atLevel = 0;
  };
  for (const auto& [from, to] : flat.runs) {
    if (out.empty() || atLevel == 0 || time(from) - time(out.back().to - 1) > kBetween) {
      close();
      out.push_back({from, to});
    }
    out.back().to = to;
    atLevel += to - from;
  }
  close();
  return out;
}

void addGaps(const VectorXd& time, std::vector<Trouble>& out) {
  constexpr double kSteps = 1.75;  // A row is missing, which a step that only jitters does not look like.
  const VectorXd steps = time.tail(time.size() - 1) - time.head(time.size() - 1);
  const double usual = median({steps.begin(), steps.end()});
  for (Eigen::Index k = 1; k < time.size(); ++k)
    if (steps(k - 1) > std::max(kSteps * usual, kGapLeftOut))
      out.push_back({time(k - 1), time(k), heft::say("Nothing was recorded here.")});
}

/// Around where the posture stands still and leaps, or leaps at once, filters make of it what no arm did.
void addLeaps(const Recording& recording, std::vector<Trouble>& out) {
  const VectorXd& time = recording.time;
  const auto add = [&](double from, double to, const std::string& reason) {
    from = std::max(time(0), from - kAroundLeap);
    to = std::min(time(time.size() - 1), to + kAroundLeap);
    if (!out.empty() && out.back().reason == reason && from <= out.back().to)
      out.back().to = to;
    else
      out.push_back({from, to, reason});
  };
  for (const FrozenStretch& hung :
       recording.hasOrientation() ? hungPostures(time, recording.quaternion) : hungPostures(time, recording.q))
    if (hung.length() < time.size())
      add(time(hung.from), time(hung.to - 1),
          heft::say("The posture is frozen here and jumps afterwards: the robot sent nothing new."));
  for (const Eigen::Index k : postureLeaps(recording))
    add(time(k - 1), time(k),
        heft::say("The posture leaps here within one row: rows are missing, or two recordings were joined."));
}

}  // namespace

std::vector<Trouble> sensorTrouble(const Recording& recording) {
  return sensorTrouble(recording, flatTops(recording.wrench));
}

std::vector<Trouble> sensorTrouble(const Recording& recording, const std::vector<FlatTop>& tops) {
  std::vector<Trouble> out;
  const auto& wrench = recording.wrench;
  const VectorXd& time = recording.time;
  if (wrench.rows() < 20) return out;
  constexpr double kShortestFreeze = 0.05;  // [s]
  const auto add = [&](const FrozenStretch& stretch, const std::string& reason) {
    if (stretch.length() < wrench.rows()) out.push_back({time(stretch.from), time(stretch.to - 1), reason});
  };
  const std::vector<Changes> each = changesOfEach(wrench);
  const Changes changes = ofAny(each);
  for (const FrozenStretch& hung : frozenStretches(time, changes, kShortestFreeze))
    add(hung, heft::say("Sensor values frozen: no new data."));
  const auto silent = silentChannels(wrench);
  const auto cut = mostlyCutOff(tops, wrench.rows());
  std::array<std::vector<FrozenStretch>, 6> alone;
  parallelFor(6, [&](std::size_t c) {
    if (!silent[c] && !cut[c]) alone[c] = frozenAlone(time, each[c], changes);
  });
  for (std::size_t c = 0; c < 6; ++c)
    for (const FrozenStretch& stretch : alone[c])
      add(stretch, heft::say("{} is frozen here while others go on: it was not measured.",
                             nameOf(static_cast<Eigen::Index>(c))));
  for (const FlatTop& flat : tops) {
    if (cut[static_cast<std::size_t>(flat.channel)]) continue;
    const std::string reason = heft::say("{} is cut off at {:.4g} {}: the sensor is at the end of its range.",
                                         nameOf(flat.channel), flat.level, flat.channel < 3 ? "N" : "N m");
    for (const FrozenStretch& stretch : cutStretches(flat, time)) add(stretch, reason);
  }
  constexpr Eigen::Index kFewestOnceMore = 50;  // Readings
  for (const Replay& replay : replayedStretches(wrench, kFewestOnceMore))
    add(replay.at,
        heft::say("The readings are those from {:.2f} s on once more: they were logged twice.", time(replay.from)));
  addGaps(time, out);
  addLeaps(recording, out);
  std::sort(out.begin(), out.end(), [](const Trouble& a, const Trouble& b) { return a.from < b.from; });
  return out;
}

}  // namespace heft
