#include "core/recording/steps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/statistics.h"

namespace heft {

std::optional<double> stepOf(std::vector<double> readings) {
  constexpr double kOff = 0.1;  // Steps: the digits of the file, or a finer converter behind a coarse one
  std::ranges::sort(readings);
  readings.erase(std::unique(readings.begin(), readings.end()), readings.end());
  if (readings.size() < 4) return std::nullopt;
  std::vector<double> apart;
  for (std::size_t i = 1; i < readings.size(); ++i) apart.push_back(readings[i] - readings[i - 1]);
  const double lowest = readings.front(), range = readings.back() - lowest;
  const double step = range / std::round(range / median(std::move(apart)));
  const bool regular = std::ranges::all_of(readings, [&](double reading) {
    const double steps = (reading - lowest) / step;
    return std::abs(steps - std::nearbyint(steps)) < kOff;
  });
  return regular ? std::optional(step) : std::nullopt;
}

ReadingSteps readingSteps(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench, double duration) {
  ReadingSteps out;
  out.duration = duration;
  for (Eigen::Index c = 0; c < 6 && wrench.rows() > 1; ++c) {
    const auto y = wrench.col(c);
    const auto step = stepOf({y.begin(), y.end()});
    if (!step) continue;
    out.step(c) = *step;
    for (Eigen::Index k = 1; k < y.size(); ++k) out.changes(c) += y(k) != y(k - 1) ? 1.0 : 0.0;
  }
  return out;
}

Vector6d ReadingSteps::roundingNoise(double seconds) const {
  const Vector6d fresh = (changes * (seconds / std::max(duration, seconds))).cwiseMax(1.0);
  return step.cwiseQuotient((12.0 * fresh).cwiseSqrt());
}

}  // namespace heft
