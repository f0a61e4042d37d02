#include "core/recording/even_times.h"

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

/// Whether a step is twice as long and the next is no shorter for it, where jitter is so small that this can be told.
bool lostOne(const std::vector<double>& steps, double typical) {
  constexpr double kLong = 1.6, kShort = 0.6, kJitter = 0.15;  // Of a step; robust deviation of the steps
  if (robustStd(steps) > kJitter * typical) return false;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i)
    if (steps[i] > kLong * typical && steps[i + 1] > kShort * typical) return true;
  return false;
}

/// Numbers of samples that followed each other at these steps, and the line through (number, stamp) [s].
struct EvenLine {
  std::vector<double> number, time;  ///< The stamps, from 0
  double step = 0.0, first = 0.0;
  double at(std::size_t i) const { return first + step * number[i]; }
};

/// `mayLose`: where steps are whole multiples of the usual one, samples were lost.
EvenLine lineThrough(const std::vector<double>& steps, bool mayLose) {
  double mean = 0.0;
  for (const double step : steps) mean += step / static_cast<double>(steps.size());
  const double typical = median(steps);
  EvenLine out;
  out.time = {0.0};
  for (const double each : steps) out.time.push_back(out.time.back() + each);
  out.number.resize(out.time.size());
  std::iota(out.number.begin(), out.number.end(), 0.0);
  if (mayLose && losesSamples(steps, typical, mean)) out.number = numbersOf(out.time, steps, typical);
  const auto n = static_cast<double>(out.number.size());
  double meanNumber = 0.0, meanTime = 0.0, product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < out.number.size(); ++i) {
    meanNumber += out.number[i] / n;
    meanTime += out.time[i] / n;
  }
  for (std::size_t i = 0; i < out.number.size(); ++i) {
    product += (out.number[i] - meanNumber) * (out.time[i] - meanTime);
    square += std::pow(out.number[i] - meanNumber, 2);
  }
  out.step = product / square;
  out.first = meanTime - out.step * meanNumber;
  return out;
}

/// Of the stamps about the line, by what 9 of 10 keep [s].
double scatterAbout(const EvenLine& line) {
  std::vector<double> off;
  for (std::size_t i = 0; i < line.time.size(); ++i) off.push_back(line.time[i] - line.at(i));
  std::sort(off.begin(), off.end());
  const auto quantile = [&off](double share) {
    return off[static_cast<std::size_t>(share * static_cast<double>(off.size()))];
  };
  return (quantile(0.95) - quantile(0.05)) / kNinety;
}

/// Joints, or the pose with a sign of the quaternion that goes on.
MatrixXd motionIn(const Recording& recording) {
  if (!recording.hasOrientation()) return recording.q;
  MatrixXd out(recording.rows(), recording.hasPosition() ? 7 : 4);
  out.leftCols<4>() = recording.quaternion;
  for (Eigen::Index i = 1; i < out.rows(); ++i)
    if (out.row(i).head<4>().dot(out.row(i - 1).head<4>()) < 0.0) out.row(i).head<4>() *= -1.0;
  if (recording.hasPosition()) out.rightCols<3>() = recording.position;
  return out;
}

}  // namespace

StampScatter stampScatter(std::vector<double> steps) {
  const auto pause = std::find_if(steps.rbegin(), steps.rend(), [](double step) { return step > kPause; });
  steps.erase(steps.begin(), pause.base());
  if (steps.size() < kFewestSteps) return {};
  const EvenLine line = lineThrough(steps, true);
  return {scatterAbout(line), line.step};
}

double roughness(const VectorXd& time, const MatrixXd& motion, Eigen::Index from) {
  constexpr double kUsual = 0.95;  // Share of the rows: leaps are leaps at any time.
  std::vector<double> squares;
  for (Eigen::Index i = from + 2; i + 2 < motion.rows(); ++i) {
    const Eigen::Index about[] = {i - 2, i - 1, i + 1, i + 2};
    Eigen::RowVectorXd off = motion.row(i);
    for (const Eigen::Index a : about) {
      double weight = 1.0;
      for (const Eigen::Index b : about)
        if (b != a) weight *= (time(i) - time(b)) / (time(a) - time(b));
      off -= weight * motion.row(a);
    }
    squares.push_back(off.squaredNorm());
  }
  const auto usual = squares.begin() + static_cast<std::ptrdiff_t>(kUsual * static_cast<double>(squares.size()));
  std::nth_element(squares.begin(), usual, squares.end());
  return std::accumulate(squares.begin(), usual, 0.0);
}

std::optional<VectorXd> evenTimes(const Recording& recording, StampScatter& scatter) {
  constexpr double kHardly = 0.02;                // Of a step: rounded stamps, or hardly any scatter
  constexpr double kGapSteps = 5.0, kGap = 0.05;  // Steps and [s] that end a stretch
  const VectorXd& time = recording.time;
  scatter = {};
  if (time.size() <= static_cast<Eigen::Index>(kFewestSteps)) return std::nullopt;
  std::vector<double> steps(static_cast<std::size_t>(time.size() - 1));
  for (std::size_t k = 0; k < steps.size(); ++k)
    steps[k] = time(static_cast<Eigen::Index>(k) + 1) - time(static_cast<Eigen::Index>(k));
  const double typical = median(steps), gap = std::max(kGapSteps * typical, kGap);
  if (std::ranges::all_of(steps, [=](double step) { return std::abs(step - typical) < kHardly * typical; }))
    return std::nullopt;
  VectorXd even = time;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> stretches;  // First row and number of rows
  double rows = 0.0;
  for (auto from = steps.begin(); from < steps.end();) {
    const auto to = std::find_if(from, steps.end(), [gap](double step) { return step > gap; });
    if (to - from >= static_cast<std::ptrdiff_t>(kFewestSteps)) {
      if (lostOne({from, to}, typical)) return std::nullopt;
      const EvenLine line = lineThrough({from, to}, false);
      const Eigen::Index first = from - steps.begin(), count = to - from + 1;
      for (Eigen::Index i = 0; i < count; ++i) even(first + i) = time(first) + line.at(static_cast<std::size_t>(i));
      const auto n = static_cast<double>(count);
      scatter.off += std::pow(scatterAbout(line), 2) * n;
      scatter.step += line.step * n;
      rows += n;
      stretches.emplace_back(first, count);
    }
    from = to == steps.end() ? to : to + 1;
  }
  if (rows <= 0.0) return std::nullopt;
  scatter = {std::sqrt(scatter.off / rows), scatter.step / rows};
  const bool rises = ((even.tail(even.size() - 1) - even.head(even.size() - 1)).array() > 0.0).all();
  if (!rises || scatter.off < kHardly * scatter.step) return std::nullopt;
  const MatrixXd motion = motionIn(recording);
  double stamped = 0.0, evened = 0.0;
  for (const auto& [first, count] : stretches) {
    const MatrixXd part = motion.middleRows(first, count);
    stamped += roughness(time.segment(first, count), part);
    evened += roughness(even.segment(first, count), part);
  }
  return evened < kClearlySmoother * stamped ? std::optional(std::move(even)) : std::nullopt;
}

}  // namespace heft
