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

Vector6d roundingNoise(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench, double duration, double seconds) {
  Vector6d out = Vector6d::Zero();
  for (Eigen::Index c = 0; c < 6 && wrench.rows() > 1; ++c) {
    const auto y = wrench.col(c);
    const auto step = stepOf({y.begin(), y.end()});
    if (!step) continue;
    Eigen::Index changes = 0;
    for (Eigen::Index k = 1; k < y.size(); ++k) changes += y(k) != y(k - 1) ? 1 : 0;
    const double fresh = static_cast<double>(changes) * seconds / std::max(duration, seconds);
    out(c) = *step / std::sqrt(12.0 * std::max(1.0, fresh));
  }
  return out;
}

}  // namespace heft
