#include "core/recording/replayed.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>

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

/// Whether most rows of a stretch are others than all of its rows before.
bool variesIn(const Wrenches& wrench, const FrozenStretch& stretch) {
  std::vector<std::uint64_t> rows;
  for (Eigen::Index k = stretch.from; k < stretch.to; ++k) rows.push_back(hashOf(wrench, k));
  const auto changes = 1 + std::ranges::count_if(rows, [before = rows.front()](std::uint64_t row) mutable {
                         return std::exchange(before, row) != row;
                       });
  std::ranges::sort(rows);
  return 2 * (std::unique(rows.begin(), rows.end()) - rows.begin()) > changes;
}

}  // namespace

std::vector<Replay> replayedStretches(const VectorXd& time, const Wrenches& wrench) {
  constexpr Eigen::Index kFewest = 50;
  constexpr double kShortest = 0.25;  // [s]
  // One row in eight or so, chosen by what it holds, so that a copy has the same.
  constexpr std::uint64_t kChosen = 8;
  std::unordered_map<std::uint64_t, Eigen::Index> first;
  std::vector<Replay> out;
  Eigen::Index next = 1;  // What lies before was looked at.
  for (Eigen::Index k = 1; k < wrench.rows(); ++k) {
    if (k < next) continue;
    const std::uint64_t hash = hashOf(wrench, k);
    if (hash % kChosen != 0 || wrench.row(k) == wrench.row(k - 1)) continue;
    const auto [known, isNew] = first.try_emplace(hash, k);
    if (isNew) continue;
    const Eigen::Index shift = k - known->second, floor = std::max(shift, out.empty() ? 0 : out.back().at.to);
    Replay found{{k, k}, 0};
    while (found.at.from > floor && wrench.row(found.at.from - 1) == wrench.row(found.at.from - 1 - shift))
      --found.at.from;
    // No longer than what it repeats: a channel that only toggles repeats itself all the time.
    while (found.at.to < std::min(wrench.rows(), found.at.from + shift) &&
           wrench.row(found.at.to) == wrench.row(found.at.to - shift))
      ++found.at.to;
    found.from = found.at.from - shift;
    if (found.at.length() < kFewest) continue;
    next = found.at.to;
    if (time(found.at.to - 1) - time(found.at.from) >= kShortest && variesIn(wrench, found.at)) out.push_back(found);
  }
  return out;
}

}  // namespace heft
