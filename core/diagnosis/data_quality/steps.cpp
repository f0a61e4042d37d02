#include "core/diagnosis/data_quality/steps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/diagnosis/calibration.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

std::optional<double> stepOf(std::vector<double> readings) {
  std::ranges::sort(readings);
  readings.erase(std::unique(readings.begin(), readings.end()), readings.end());
  if (readings.size() < 4) return std::nullopt;
  std::vector<double> apart;
  for (std::size_t i = 1; i < readings.size(); ++i) apart.push_back(readings[i] - readings[i - 1]);
  const double lowest = readings.front(), range = readings.back() - lowest;
  const double step = range / std::round(range / median(std::move(apart)));
  const bool regular = std::ranges::all_of(readings, [&](double reading) {
    const double steps = (reading - lowest) / step;
    return std::abs(steps - std::nearbyint(steps)) < kSmallShare;
  });
  return regular ? std::optional(step) : std::nullopt;
}

}  // namespace heft::diagnosis
