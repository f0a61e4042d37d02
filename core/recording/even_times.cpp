#include "core/online/stamp_scatter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/statistics.h"

namespace heft {

namespace {

constexpr std::size_t kFewestSteps = 200;
constexpr double kNinety = 3.29;     // Standard deviations between the normal distribution's 5 % and 95 %
constexpr double kPause = 0.25;      // [s]
constexpr double kEven = 0.25;       // Of a step: as near to a whole number of steps
constexpr double kMostlyEven = 0.9;  // Share of such steps where samples are lost and stamps are even
constexpr double kMostLost = 3.0;    // Mean over median step; beyond, samples are stamped in bursts

/// Whether the steps are whole multiples of `typical`, as where samples were lost.
bool losesSamples(const std::vector<double>& steps, double typical, double mean) {
  if (mean > kMostLost * typical) return false;
  const auto even = std::ranges::count_if(steps, [typical](double step) {
    const double times = std::max(1.0, std::round(step / typical));
    return std::abs(step / typical - times) < kEven;
  });
  return static_cast<double>(even) > kMostlyEven * static_cast<double>(steps.size());
}

/// Number of each sample where some were lost: what is late is so for a while, what was lost delays all that follows.
std::vector<double> numbersOf(const std::vector<double>& time, const std::vector<double>& steps, double typical) {
  double near = 0.0, count = 0.0;
  for (const double step : steps)
    if (std::abs(step - typical) < kEven * typical) {
      near += step;
      count += 1.0;
    }
  const double whole = near / count;
  std::vector<double> out(time.size());
  double behind = INFINITY;
  for (std::size_t i = time.size(); i-- > 0;) {
    behind = std::min(behind, time[i] / whole - static_cast<double>(i));
    out[i] = behind;
  }
  const double first = out.front();
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<double>(i) + std::round(out[i] - first);
  return out;
}

}  // namespace

StampScatter stampScatter(std::vector<double> steps) {
  const auto pause = std::find_if(steps.rbegin(), steps.rend(), [](double step) { return step > kPause; });
  steps.erase(steps.begin(), pause.base());
  if (steps.size() < kFewestSteps) return {};
  double mean = 0.0;
  for (const double step : steps) mean += step / static_cast<double>(steps.size());
  const double typical = median(steps);
  std::vector<double> time{0.0};
  for (const double each : steps) time.push_back(time.back() + each);
  std::vector<double> number(time.size());
  std::iota(number.begin(), number.end(), 0.0);
  if (losesSamples(steps, typical, mean)) number = numbersOf(time, steps, typical);
  // The line through (number, stamp).
  const auto n = static_cast<double>(number.size());
  double meanNumber = 0.0, meanTime = 0.0, product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    meanNumber += number[i] / n;
    meanTime += time[i] / n;
  }
  for (std::size_t i = 0; i < number.size(); ++i) {
    product += (number[i] - meanNumber) * (time[i] - meanTime);
    square += std::pow(number[i] - meanNumber, 2);
  }
  const double step = product / square;
  std::vector<double> off;
  for (std::size_t i = 0; i < number.size(); ++i) off.push_back(time[i] - meanTime - step * (number[i] - meanNumber));
  std::sort(off.begin(), off.end());
  const auto quantile = [&off](double share) {
    return off[static_cast<std::size_t>(share * static_cast<double>(off.size()))];
  };
  return {(quantile(0.95) - quantile(0.05)) / kNinety, step};
}

}  // namespace heft
