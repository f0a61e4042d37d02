#include "core/estimation/spikes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/stop.h"
#include "core/math/statistics.h"
#include "core/recording/frozen.h"
#include "core/recording/wrench_runs.h"

namespace heft {

namespace {

constexpr Eigen::Index kLevel = 7;              ///< Rows whose median is the level beside a discharge
constexpr Eigen::Index kLongestDischarge = 24;  ///< Rows of a discharge
constexpr double kHolds = 0.35;                 ///< Of its height in the second row; a single reading far off is none
constexpr double kMostSpikeShare = 0.05;        ///< Of a channel's rows; what happens all the time is the signal
/// Of a spike's or discharge's height: within that it has fallen back, the load having moved on.
constexpr double kBack = 0.15;
constexpr std::size_t kFewestDischarges = 3;

/// `times` the scatter of one channel, for each `part` rows: that there or beside, and at least the usual one. Empty
/// where there is too little of it. `off`: how far row i is from where its neighbours have it; 0 where they say
/// nothing.
template <class Off>
std::vector<double> limitsBy(const Off& off, Eigen::Index rows, Eigen::Index part, double times) {
  constexpr std::size_t kFewest = 20;
  std::vector<double> all, here, scatter;
  all.reserve(static_cast<std::size_t>(rows));
  for (Eigen::Index i = 1; i < rows; ++i) {
    if (const double size = std::abs(off(i)); size > 0.0) here.push_back(size);
    if ((i + 1) % part != 0 && i + 1 < rows) continue;
    all.insert(all.end(), here.begin(), here.end());
    scatter.push_back(here.size() < kFewest ? 0.0 : median(std::move(here)));
    here.clear();
  }
  if (all.size() < kFewest) return {};
  const double usual = median(std::move(all));
  std::vector<double> out(scatter.size());
  for (std::size_t k = 0; k < scatter.size(); ++k) {
    const double beside = std::max(scatter[k > 0 ? k - 1 : 0], scatter[std::min(k + 1, scatter.size() - 1)]);
    out[k] = times * std::max({usual, scatter[k], beside});
  }
  return out;
}

/// How far a reading of one channel must leap, by steps between rows that differ: repeated rows of a polled sensor say
/// nothing about its noise.
std::vector<double> leapLimits(const Eigen::Ref<const Eigen::VectorXd>& channel, Eigen::Index part) {
  constexpr double kTimes = 8.0 * 1.4826 / std::numbers::sqrt2;
  return limitsBy([&](Eigen::Index i) { return channel(i) - channel(i - 1); }, channel.size(), part, kTimes);
}

/// How far a single reading must stand out: where rows are few and the load moves fast, steps are the load's own, and
/// how far a reading usually is from half-way between those two rows before and after tells the noise.
std::vector<double> spikeLimits(const Eigen::Ref<const Eigen::VectorXd>& channel, Eigen::Index part,
                                std::vector<double> leaps) {
  constexpr double kTimes = 10.0 * 1.4826 / 1.2247, kClearly = 0.8;  // The root of 1 + 1/4 + 1/4
  const auto off = [&](Eigen::Index i) {
    const bool differs =
        i > 1 && i + 2 < channel.size() && channel(i) != channel(i - 1) && channel(i) != channel(i + 1);
    return differs ? channel(i) - 0.5 * (channel(i - 2) + channel(i + 2)) : 0.0;
  };
  const auto bends = limitsBy(off, channel.size(), part, kTimes);
  for (std::size_t k = 0; k < std::min(leaps.size(), bends.size()); ++k)
    if (bends[k] < kClearly * leaps[k]) leaps[k] = bends[k];
  return leaps;
}

/// A channel leaps in one row, no other with it, and falls back.
struct Discharge {
  int channel = 0;
  Eigen::Index from = 0, to = 0;     ///< Rows [from, to)
  double before = 0.0, after = 0.0;  ///< Levels on either side
};

double medianOf(const WrenchSamples& wrench, int channel, Eigen::Index from) {
  const auto rows = wrench.col(channel).segment(from, kLevel);
  return median(std::vector<double>(rows.data(), rows.data() + kLevel));
}

/// The discharge whose first row is `i`, where the channel leaps, if there is one. `limits`: of each channel, in the
/// part that `i` is in. `apart`: rows within which no other channel leaps.
std::optional<Discharge> dischargeAt(const WrenchSamples& wrench, Eigen::Index i, int channel,
                                     const std::array<double, 6>& limits, Eigen::Index apart) {
  const double limit = limits[static_cast<std::size_t>(channel)], last = wrench(i - 1, channel);
  // Where the load moves fast, one step is like those before it.
  constexpr double kSteps = 4.0;
  std::vector<double> steps;
  for (Eigen::Index k = i - 2 * kLevel; k < i; ++k)
    steps.push_back(std::abs(wrench(k, channel) - wrench(k - 1, channel)));
  if (std::abs(wrench(i, channel) - last) < kSteps * median(std::move(steps))) return {};
  // A reading that was held leaps, too, when it is fresh again.
  if (last == wrench(i - 2, channel) && last == wrench(i - 3, channel)) return {};
  Discharge out{channel, i, i, medianOf(wrench, channel, i - kLevel), 0.0};
  const double height = wrench(i, channel) - out.before;
  if (std::abs(height) < limit || (wrench(i + 1, channel) - out.before) / height < kHolds) return {};
  // A knock is felt on several channels.
  for (int c = 0; c < 6; ++c)
    for (Eigen::Index k = i - apart; k < i + 1 + 2 * apart && c != channel; ++k)
      if (std::abs(wrench(k, c) - wrench(k - 1, c)) > 0.75 * limits[static_cast<std::size_t>(c)]) return {};
  // Where the channel would have gone, by its way before.
  const double slope = (out.before - medianOf(wrench, channel, i - 3 * kLevel)) / static_cast<double>(2 * kLevel);
  for (out.to = i + 1; out.to <= i + kLongestDischarge; ++out.to) {
    if (out.to + 2 * kLevel > wrench.rows()) return {};
    // It is the highest where it begins.
    if ((wrench(out.to, channel) - out.before) / height > 1.2) return {};
    out.after = medianOf(wrench, channel, out.to);
    const double off = out.after - out.before - slope * static_cast<double>(out.to - i + kLevel);
    const double falls = medianOf(wrench, channel, out.to + kLevel) - out.after;
    if (std::abs(off) < std::max(0.5 * limit, kBack * std::abs(height)) && std::abs(falls) < 0.5 * limit) break;
  }
  if (out.to > i + kLongestDischarge) return {};
  return out;
}

using Limits = std::array<std::vector<double>, 6>;

/// Replaces discharges by lines, marks their rows and says how many there were.
std::size_t bridgeDischarges(WrenchSamples& wrench, const Limits& limits, Eigen::Index part, Eigen::Index apart,
                             std::vector<bool>& touched) {
  std::array<std::vector<Discharge>, 6> ofEach;
  parallelFor(ofEach.size(), [&](std::size_t channel) {
    const int c = static_cast<int>(channel);
    std::vector<Discharge>& found = ofEach[channel];
    Eigen::Index rows = 0;
    const auto& own = limits[channel];
    for (Eigen::Index i = 3 * kLevel; i + kLevel + 4 < wrench.rows() && !own.empty(); ++i) {
      if (std::abs(wrench(i, c) - wrench(i - 1, c)) < own[static_cast<std::size_t>(i / part)]) continue;
      std::array<double, 6> here{};
      for (std::size_t k = 0; k < 6; ++k)
        here[k] = limits[k].empty() ? 1e300 : limits[k][static_cast<std::size_t>(i / part)];
      const auto discharge = dischargeAt(wrench, i, c, here, apart);
      if (!discharge) continue;
      found.push_back(*discharge);
      rows += discharge->to - discharge->from;
      i = discharge->to;
    }
    if (static_cast<double>(rows) > kMostSpikeShare * static_cast<double>(wrench.rows())) found.clear();
  });
  std::vector<Discharge> found;
  for (const auto& each : ofEach) found.insert(found.end(), each.begin(), each.end());
  if (found.size() < kFewestDischarges) return 0;
  for (const Discharge& d : found)
    for (Eigen::Index i = d.from; i < d.to; ++i) {
      const double share = static_cast<double>(i - d.from + 1) / static_cast<double>(d.to - d.from + 1);
      wrench(i, d.channel) = d.before + share * (d.after - d.before);
      touched[static_cast<std::size_t>(i)] = true;
    }
  return found.size();
}

/// Replaces single readings far off by what lies around them, marks their rows and says how many there were. Where
/// their limits are below those of leaps, the load moves fast.
std::size_t replaceSingles(WrenchSamples& wrench, const Limits& allLimits, const Limits& leaps, Eigen::Index part,
                           std::vector<bool>& touched) {
  const Eigen::Index n = wrench.rows();
  std::array<std::vector<std::pair<Eigen::Index, double>>, 6> ofEach;
  parallelFor(ofEach.size(), [&](std::size_t channel) {
    const auto c = static_cast<Eigen::Index>(channel);
    const auto& limits = allLimits[channel];
    auto& found = ofEach[channel];
    if (limits.empty()) return;
    for (Eigen::Index i = 3; i + 3 < n; ++i) {
      const double limit = limits[static_cast<std::size_t>(i / part)];
      const auto rows = wrench.col(c).segment(i - 3, 7);
      // Cheap test first: a spike stands out from where neighbours on either side of it have it.
      const auto off = [&](Eigen::Index away) { return std::abs(rows(3) - 0.5 * (rows(3 - away) + rows(3 + away))); };
      if (off(3) < limit && off(2) < limit) continue;
      // Without the way that the load goes meanwhile.
      const Eigen::Array<double, 7, 1> course = Eigen::Array<double, 7, 1>::LinSpaced(-3.0, 3.0);
      const bool moves = limit < leaps[channel][static_cast<std::size_t>(i / part)];
      const double slope =
          !moves ? 0.0 : median({(rows(6) - rows(0)) / 6.0, (rows(5) - rows(1)) / 4.0, (rows(4) - rows(2)) / 2.0});
      const Eigen::Array<double, 7, 1> near = rows.array() - slope * course;
      const auto standsOut = [&](Eigen::Index away) {
        const double before = near(3) - near(3 - away), after = near(3) - near(3 + away);
        return std::abs(before) >= limit && std::abs(after) >= limit && before * after > 0.0;
      };
      if (!standsOut(2) && (moves || !standsOut(3))) continue;
      const double centre = median(std::vector<double>(near.data(), near.data() + 7));
      const double height = std::abs(wrench(i, c) - centre);
      if (height < limit) continue;
      // Three or more samples far out are an event, not a spike.
      // So is where the load takes another way.
      const double aside = moves ? 0.35 : 0.5;
      if (((near - centre).abs() > std::max(aside * limit, kBack * height)).count() > 2) continue;
      found.emplace_back(i, centre);
    }
    if (static_cast<double>(found.size()) > kMostSpikeShare * static_cast<double>(n)) found.clear();
  });
  std::size_t all = 0;
  for (std::size_t c = 0; c < ofEach.size(); ++c) {
    for (const auto& [i, centre] : ofEach[c]) {
      wrench(i, static_cast<Eigen::Index>(c)) = centre;
      touched[static_cast<std::size_t>(i)] = true;
    }
    all += ofEach[c].size();
  }
  return all;
}

}  // namespace

std::optional<WrenchSamples> withoutZeros(const Eigen::VectorXd& time, const WrenchSamples& wrench,
                                          Eigen::Index& replaced) {
  constexpr double kLongest = 0.02;  // [s] A block of the estimate
  const auto isZero = [&](Eigen::Index row) { return wrench(row, 0) == 0.0 && wrench.row(row).isZero(0.0); };
  Runs runs;
  Eigen::Index zeros = 0;
  for (Eigen::Index from = 0; from < wrench.rows();) {
    auto to = from;
    while (to < wrench.rows() && isZero(to)) ++to;
    zeros += to - from;
    if (to > from && from > 0 && to < wrench.rows() && time(to) - time(from - 1) < kLongest)
      runs.emplace_back(from, to);
    from = to + 1;
  }
  if (runs.empty() || 2 * zeros > wrench.rows()) return std::nullopt;
  const Changes changes = changesOf(wrench);
  std::erase_if(runs, [&](const auto& run) {
    return changes[static_cast<std::size_t>(run.first)] != 2 || changes[static_cast<std::size_t>(run.second)] != 2;
  });
  if (runs.empty()) return std::nullopt;
  WrenchSamples out = wrench;
  straightOver(runs, time, out);
  for (const auto& [from, to] : runs) replaced += to - from;
  return out;
}

WrenchSamples withoutSpikes(const WrenchSamples& wrench, Eigen::Index& replaced) {
  constexpr Eigen::Index kPart = 500;  // Rows: half a second or so, in which noise may be louder than elsewhere
  constexpr std::size_t kMany = 50;
  WrenchSamples out = wrench;
  std::vector<bool> touched(static_cast<std::size_t>(wrench.rows()), false);
  Limits leaps, spikes;
  parallelFor(6, [&](std::size_t c) {
    const auto channel = wrench.col(static_cast<Eigen::Index>(c));
    leaps[c] = leapLimits(channel, kPart);
    spikes[c] = spikeLimits(channel, kPart, leaps[c]);
  });
  stopPoint();
  // Where there are many, some hide one another.
  if (replaceSingles(out, spikes, leaps, kPart, touched) >= kMany) replaceSingles(out, spikes, leaps, kPart, touched);
  stopPoint();
  if (bridgeDischarges(out, leaps, kPart, 1, touched) >= kMany) bridgeDischarges(out, leaps, kPart, 0, touched);
  replaced = std::count(touched.begin(), touched.end(), true);
  return out;
}

}  // namespace heft
