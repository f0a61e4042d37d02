#include "ui/wrench_plots/min_max_pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace heft {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

}  // namespace

/// A comparison with NaN is false: written like this an absent value changes nothing and an absent extreme is replaced.
void MinMaxPyramid::include(Extremes& extremes, const Extremes& other) {
  if (!(extremes.lowest <= other.lowest) && other.lowest == other.lowest) extremes.lowest = other.lowest;
  if (!(extremes.highest >= other.highest) && other.highest == other.highest) extremes.highest = other.highest;
}

MinMaxPyramid::MinMaxPyramid(const std::vector<double>& values) : values_(values.begin(), values.end()) {
  if (values_.size() < 2 * kBase) return;
  std::vector<Extremes> level((values_.size() + kBase - 1) / kBase, Extremes{kNan, kNan});
  for (std::size_t i = 0; i < values_.size(); ++i) include(level[i / kBase], {values_[i], values_[i]});
  while (level.size() >= 2 * kFactor) {
    std::vector<Extremes> next((level.size() + kFactor - 1) / kFactor, Extremes{kNan, kNan});
    for (std::size_t i = 0; i < level.size(); ++i) include(next[i / kFactor], level[i]);
    levels_.push_back(std::move(level));
    level = std::move(next);
  }
  levels_.push_back(std::move(level));
}

MinMax MinMaxPyramid::range(std::size_t from, std::size_t to) const {
  Extremes extremes{kNan, kNan};
  to = std::min(to, values_.size());
  // Climb: single samples up to the next block border, then whole blocks, each time as large as fits.
  while (from < to) {
    std::size_t span = 1, level = 0;
    std::size_t candidate = kBase;
    while (level < levels_.size() && from % candidate == 0 && from + candidate <= to) {
      span = candidate;
      candidate *= kFactor;
      ++level;
    }
    if (span == 1) {
      include(extremes, {values_[from], values_[from]});
    } else {
      include(extremes, levels_[level - 1][from / span]);
    }
    from += span;
  }
  return {extremes.lowest, extremes.highest};
}

}  // namespace heft
