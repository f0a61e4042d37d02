#include "core/diagnosis/data_quality/stuck_bit.h"

#include <algorithm>
#include <cmath>

#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

struct Gap {
  double from, width;
};

/// Readings in order without the rare ones at either end.
std::vector<double> usualOnes(std::vector<double> readings) {
  constexpr std::ptrdiff_t kRare = 50;  // Of so many readings, one at either end
  std::ranges::sort(readings);
  const std::ptrdiff_t rare = std::ssize(readings) / kRare;
  return {readings.begin() + rare, readings.end() - rare};
}

/// Gaps between readings in order that are many times wider than chance leaves.
std::vector<Gap> gapsIn(const std::vector<double>& ordered) {
  constexpr double kTimes = 30.0;
  const double usual = (ordered.back() - ordered.front()) / static_cast<double>(ordered.size());
  std::vector<Gap> out;
  for (std::size_t i = 0; i + 1 < ordered.size(); ++i)
    if (const double width = ordered[i + 1] - ordered[i]; width > kTimes * usual) out.push_back({ordered[i], width});
  return out;
}

}  // namespace

std::vector<StuckBit> stuckBits(const Recording& recording) {
  std::vector<StuckBit> out;
  for (Eigen::Index c = 0; c < 6; ++c) {
    stopPoint();
    const auto ordered = usualOnes({recording.wrench.col(c).begin(), recording.wrench.col(c).end()});
    if (ordered.empty()) continue;
    const auto gaps = gapsIn(ordered);
    if (gaps.size() < kPattern) continue;
    std::vector<double> widths;
    for (const Gap& gap : gaps) widths.push_back(gap.width);
    const double worth = median(widths);
    if (2.0 * worth * static_cast<double>(gaps.size()) < kMajority * (ordered.back() - ordered.front())) continue;
    std::size_t fits = 0;
    for (std::size_t i = 1; i < gaps.size(); ++i) {
      const double apart = (gaps[i].from - gaps[i - 1].from) / worth;
      fits += std::abs(gaps[i].width / worth - 1.0) < kMinorShare && std::abs(apart - 2.0) < kMinorShare ? 1 : 0;
    }
    if (static_cast<double>(fits) > kLargeShare * static_cast<double>(gaps.size() - 1)) out.push_back({c, worth});
  }
  return out;
}

}  // namespace heft::diagnosis
