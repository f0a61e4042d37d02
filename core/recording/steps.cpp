#include "core/recording/steps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "core/base/parallel.h"
#include "core/math/statistics.h"

namespace heft {

namespace {

/// Each value once, where there are so few that looking them up is quicker than sorting the readings: a converter of 16
/// bit has no more.
std::optional<std::vector<double>> fewValuesOf(const std::vector<double>& readings) {
  constexpr std::size_t kMost = 1U << 16U, kPlaces = 4 * kMost;
  if (readings.size() < kPlaces) return std::nullopt;
  std::vector<double> places(kPlaces), out;
  std::vector<bool> taken(kPlaces);
  for (const double value : readings) {
    // Zero has two signs, and is one value.
    std::size_t at = (std::bit_cast<std::uint64_t>(value + 0.0) * 0x9E3779B97F4A7C15U) >> 46U;
    while (taken[at] && places[at] != value) at = (at + 1) % kPlaces;
    if (taken[at]) continue;
    if (out.size() == kMost) return std::nullopt;
    taken[at] = true;
    places[at] = value;
    out.push_back(value);
  }
  return out;
}

/// The values that occur, in order.
std::vector<double> valuesOf(std::vector<double> readings) {
  if (auto few = fewValuesOf(readings)) readings = std::move(*few);
  std::ranges::sort(readings);
  readings.erase(std::unique(readings.begin(), readings.end()), readings.end());
  return readings;
}

/// As stepOf(), of valuesOf().
std::optional<double> stepBetween(const std::vector<double>& values) {
  constexpr double kOff = 0.1;  // Steps: the digits of the file, or a finer converter behind a coarse one
  if (values.size() < 4) return std::nullopt;
  std::vector<double> apart;
  apart.reserve(values.size());
  for (std::size_t i = 1; i < values.size(); ++i) apart.push_back(values[i] - values[i - 1]);
  const double lowest = values.front(), range = values.back() - lowest;
  const double step = range / std::round(range / median(std::move(apart)));
  const bool regular = std::ranges::all_of(values, [&](double value) {
    const double steps = (value - lowest) / step;
    return std::abs(steps - std::nearbyint(steps)) < kOff;
  });
  return regular ? std::optional(step) : std::nullopt;
}

/// Of one channel. Two or three values in many readings are steps, too, whatever lies between them.
double stepOfChannel(std::vector<double> readings) {
  constexpr std::size_t kMany = 20;
  const bool many = readings.size() >= kMany;
  const std::vector<double> values = valuesOf(std::move(readings));
  if (const auto step = stepBetween(values)) return *step;
  if (!many || values.size() < 2 || values.size() > 3) return 0.0;
  return std::min(values[1] - values[0], values.back() - values[values.size() - 2]);
}

/// Sum of the ways between one mean of `window` readings and the next, in steps; no more than there are readings.
double stepsPassed(const VectorXd& readings, double step, Eigen::Index window) {
  double passed = 0.0;
  for (Eigen::Index from = window; from + window <= readings.size(); from += window) {
    const double way = readings.segment(from, window).mean() - readings.segment(from - window, window).mean();
    passed += std::min(std::abs(way) / step, static_cast<double>(window));
  }
  return passed;
}

}  // namespace

std::optional<double> stepOf(std::vector<double> readings) { return stepBetween(valuesOf(std::move(readings))); }

ReadingSteps readingSteps(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench, double duration) {
  constexpr double kWindow = 0.1;  // [s] Hands guide an arm below 2.5 Hz; noise is averaged.
  ReadingSteps out;
  out.duration = duration;
  const double rows = static_cast<double>(wrench.rows());
  const auto window = std::max<Eigen::Index>(1, std::lround(rows * kWindow / std::max(duration, kWindow)));
  parallelFor(wrench.rows() > 1 ? 6 : 0, [&](std::size_t channel) {
    const auto c = static_cast<Eigen::Index>(channel);
    const VectorXd y = wrench.col(c);
    const double step = stepOfChannel({y.begin(), y.end()});
    if (step <= 0.0) return;
    out.step(c) = step;
    double way = 0.0;
    for (Eigen::Index k = 1; k < y.size(); ++k) {
      out.changes(c) += y(k) != y(k - 1) ? 1.0 : 0.0;
      way += std::abs(y(k) - y(k - 1));
    }
    out.crossings(c) = stepsPassed(y, step, window);
    // Rounded or not, readings go the same way on average (Buffon's needle): 2 / sqrt(pi) deviations by noise alone.
    const double each = way / rows, load = out.crossings(c) * step / rows;
    out.dither(c) = 0.5 * std::sqrt(std::numbers::pi * std::max(0.0, each * each - load * load));
  });
  return out;
}

Vector6d ReadingSteps::roundingNoise(double seconds) const {
  const double share = seconds / std::max(duration, seconds);
  Vector6d out = Vector6d::Zero();
  for (Eigen::Index c = 0; c < 6; ++c) {
    if (step(c) <= 0.0) continue;
    const double phase = 2.0 * std::numbers::pi * dither(c) / step(c);
    const double ofLoad = std::exp(-phase * phase);
    out(c) = step(c) * std::sqrt((ofLoad / (share * std::max(crossings(c), 1.0)) +
                                  (1.0 - ofLoad) / std::max(share * changes(c), 1.0)) /
                                 12.0);
  }
  return out;
}

}  // namespace heft
