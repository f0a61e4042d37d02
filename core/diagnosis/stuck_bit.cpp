#include "core/diagnosis/stuck_bit.h"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

struct Gap {
  double from, width;
};

/// Gaps between readings in order that are many times wider than chance leaves, the rare readings at either end aside.
std::vector<Gap> gapsIn(const std::vector<double>& ordered) {
  constexpr double kTimes = 30.0;
  constexpr std::size_t kRare = 50;  // Of so many readings, one at either end
  const std::size_t first = ordered.size() / kRare, last = ordered.size() - 1 - first;
  const double usual = (ordered[last] - ordered[first]) / static_cast<double>(ordered.size());
  std::vector<Gap> out;
  for (std::size_t i = first; i < last; ++i)
    if (const double width = ordered[i + 1] - ordered[i]; width > kTimes * usual) out.push_back({ordered[i], width});
  return out;
}

}  // namespace

std::vector<StuckBit> stuckBits(const Recording& recording) {
  constexpr std::size_t kFewest = 4;         // Gaps
  constexpr double kOff = 0.2, kMost = 0.8;  // How far a gap may be off in width and place, and how many must not be
  std::vector<StuckBit> out;
  for (Eigen::Index c = 0; c < 6; ++c) {
    std::vector<double> ordered(recording.wrench.col(c).begin(), recording.wrench.col(c).end());
    std::ranges::sort(ordered);
    const auto gaps = gapsIn(ordered);
    if (gaps.size() < kFewest) continue;
    std::vector<double> widths;
    for (const Gap& gap : gaps) widths.push_back(gap.width);
    const double worth = median(widths);
    std::size_t fits = 0;
    for (std::size_t i = 1; i < gaps.size(); ++i) {
      const double apart = (gaps[i].from - gaps[i - 1].from) / worth;
      fits += std::abs(gaps[i].width / worth - 1.0) < kOff && std::abs(apart - 2.0) < kOff ? 1 : 0;
    }
    if (static_cast<double>(fits) > kMost * static_cast<double>(gaps.size() - 1)) out.push_back({c, worth});
  }
  return out;
}

}  // namespace heft::diagnosis
