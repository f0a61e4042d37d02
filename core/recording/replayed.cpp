#include "core/recording/replayed.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "core/base/stop.h"

namespace heft {

namespace {

using Wrenches = Eigen::Matrix<double, Eigen::Dynamic, 6>;

std::uint64_t hashOf(const Wrenches& wrench, Eigen::Index row) {
  std::uint64_t out = 0;
  for (Eigen::Index c = 0; c < 6; ++c) {
    out = (out ^ std::bit_cast<std::uint64_t>(wrench(row, c))) * 0x9e3779b97f4a7c15u;  // Golden ratio (Knuth)
    out ^= out >> 29;
  }
  return out;
}

/// Whether a stretch has at least `fewest` readings, and most of them are others than all before.
bool varies(const Wrenches& wrench, const FrozenStretch& stretch, Eigen::Index fewest) {
  std::vector<std::uint64_t> readings;
  for (Eigen::Index k = stretch.from; k < stretch.to; ++k) {
    const std::uint64_t hash = hashOf(wrench, k);
    if (readings.empty() || hash != readings.back()) readings.push_back(hash);
  }
  const auto count = std::ssize(readings);
  std::ranges::sort(readings);
  return count >= fewest && 2 * (std::unique(readings.begin(), readings.end()) - readings.begin()) > count;
}

}  // namespace

std::vector<Replay> replayedStretches(const Wrenches& wrench, Eigen::Index fewest) {
  // Looked up are rows chosen by what they hold, so that a copy has the same: about six of the fewest readings.
  const auto oneIn = static_cast<std::uint64_t>(std::max<Eigen::Index>(1, fewest / 6));
  std::unordered_map<std::uint64_t, Eigen::Index> seen;  // Where last
  std::vector<Replay> out;
  Eigen::Index next = 1;  // What lies before was looked at.
  for (Eigen::Index k = 1; k < wrench.rows(); ++k) {
    if (k % kRowsBetweenStops == 0) stopPoint();
    const std::uint64_t hash = hashOf(wrench, k);
    if (hash % oneIn != 0 || wrench.row(k) == wrench.row(k - 1)) continue;
    const auto [known, isNew] = seen.try_emplace(hash, k);
    const Eigen::Index shift = k - std::exchange(known->second, k), floor = std::max(shift, next);
    if (isNew || k < next) continue;
    Replay found{{k, k}, 0};
    while (found.at.from > floor && wrench.row(found.at.from - 1) == wrench.row(found.at.from - 1 - shift))
      --found.at.from;
    // No longer than what it repeats: a channel that only toggles repeats itself all the time.
    while (found.at.to < std::min(wrench.rows(), found.at.from + shift) &&
           wrench.row(found.at.to) == wrench.row(found.at.to - shift))
      ++found.at.to;
    found.from = found.at.from - shift;
    if (found.at.length() < fewest) continue;
    next = found.at.to;
    if (varies(wrench, found.at, fewest)) out.push_back(found);
  }
  return out;
}

}  // namespace heft
