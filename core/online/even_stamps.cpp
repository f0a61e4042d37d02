#include "core/online/even_stamps.h"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.h"

namespace heft {

namespace {

constexpr std::size_t kJudged = 100;             // Samples that are judged together,
constexpr std::size_t kSettling = 20;            // but for the first of a stretch, in which the clock finds its phase
constexpr double kClearly = 0.25;                // Of the other's roughness, which is a square
constexpr double kSteady = 0.2;                  // Of a step
constexpr double kLost = 1.75, kTooEarly = 0.4;  // Steps since the sample before
constexpr int kAgain = 3;

/// How far each sample lies off the cubic through its two neighbours on both sides, squared and summed.
template <class Samples, class Time>
double roughness(const Samples& samples, std::size_t from, const Time& time) {
  double out = 0.0;
  for (std::size_t i = from + 2; i + 2 < samples.size(); ++i) {
    const std::size_t about[] = {i - 2, i - 1, i + 1, i + 2};
    VectorXd off = samples[i].motion;
    for (const std::size_t a : about) {
      double weight = 1.0;
      for (const std::size_t b : about)
        if (b != a) weight *= (time(samples[i]) - time(samples[b])) / (time(samples[a]) - time(samples[b]));
      off -= weight * samples[a].motion;
    }
    out += off.squaredNorm();
  }
  return out;
}

}  // namespace

double EvenStamps::followed(double stamp) {
  double passed = 1.0;
  if (step_ > 0.0 && !recent_.empty()) {
    const double steps = (stamp - even_) / step_;
    if (steps > kLost) passed = std::round(steps);
    // One that came late was taken for a lost one.
    early_ = steps < kTooEarly ? early_ + 1 : 0;
    if (early_ >= kAgain) {
      clock_ = {};
      early_ = 0;
    }
  }
  number_ += static_cast<std::int64_t>(passed);
  even_ = clock_.timeOf(number_, stamp);
  return even_;
}

double EvenStamps::timeOf(double stamp, VectorXd motion) {
  if (recent_.size() >= kJudged) {
    recent_.clear();
    settled_ = 0;
  }
  changed_ = false;
  recent_.push_back({stamp, followed(stamp), std::move(motion)});
  if (step_ <= 0.0 ? recent_.size() == kSettling : recent_.size() == kJudged) judge();
  return used_ ? recent_.back().even : stamp;
}

void EvenStamps::judge() {
  std::vector<double> steps, off;
  for (std::size_t i = 1; i < recent_.size(); ++i) steps.push_back(recent_[i].stamp - recent_[i - 1].stamp);
  const bool first = step_ <= 0.0;
  step_ = median(steps);
  if (first || recent_.size() < kJudged) return;
  for (std::size_t i = settled_; i < recent_.size(); ++i) off.push_back(recent_[i].stamp - recent_[i].even);
  const double stamped = roughness(recent_, settled_, [](const Sample&s) { return s.stamp; }),
               even = roughness(recent_, settled_, [](const Sample&s) { return s.even; });
  const bool before = used_;
  if (robustStd(off) > kSteady * step_ || stamped < kClearly * even)
    used_ = false;
  else if (even < kClearly * stamped)
    used_ = true;
  changed_ = used_ && !before;
}

std::vector<double> EvenStamps::corrected() const {
  std::vector<double> out;
  for (std::size_t i = 0; i < recent_.size() && changed_; ++i) out.push_back(recent_[i].even);
  return out;
}

void EvenStamps::beginStretch() {
  recent_.clear();
  clock_ = {};
  early_ = 0;
  settled_ = kSettling;
}

}  // namespace heft
