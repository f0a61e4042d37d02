#include "core/diagnosis/data_quality/clipping.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/diagnosis/calibration.h"

namespace heft::diagnosis {

namespace {

/// How much the mean drops when the share `cut` of a normal distribution is cut off, for one by which it then lies
/// below the level.
double lostMean(double cut) {
  const auto above = [](double z) { return 0.5 * std::erfc(z / std::numbers::sqrt2); };
  double low = 0.0, high = 6.0;  // Of the level above the mean, in deviations.
  for (int i = 0; i < 40; ++i) {
    const double z = 0.5 * (low + high);
    (above(z) > cut ? low : high) = z;
  }
  const double drop = std::exp(-0.5 * low * low) / std::sqrt(2.0 * std::numbers::pi) - low * above(low);
  return drop / (low + drop);
}

}  // namespace

Unclipped unclipped(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench, const std::vector<FlatTop>& tops,
                    double rateHz) {
  Unclipped out{wrench, std::vector<bool>(static_cast<std::size_t>(wrench.rows()), false)};
  const auto window = std::max<Eigen::Index>(4, std::lround(kShortestGap * rateHz));
  for (const FlatTop& flat : tops) {
    const auto column = wrench.col(flat.channel);
    auto run = flat.runs.begin();
    for (Eigen::Index from = 0; from < wrench.rows(); from += window) {
      const Eigen::Index to = std::min(wrench.rows(), from + window);
      std::vector<Eigen::Index> cut;
      for (; run != flat.runs.end() && run->first < to; ++run) {
        for (Eigen::Index i = std::max(from, run->first); i < std::min(to, run->second); ++i) cut.push_back(i);
        if (run->second > to) break;  // It goes on in the next window.
      }
      if (cut.empty()) continue;
      const auto all = static_cast<double>(to - from), clipped = static_cast<double>(cut.size());
      if (clipped > kMajority * all) {
        for (const Eigen::Index i : cut) out.lost[static_cast<std::size_t>(i)] = true;
      } else {
        const double below = flat.level - column.segment(from, to - from).mean();
        const double raised = flat.level + below * lostMean(clipped / all) * all / clipped;
        for (const Eigen::Index i : cut) out.wrench(i, flat.channel) = raised;
      }
    }
  }
  return out;
}

}  // namespace heft::diagnosis
