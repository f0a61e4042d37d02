#include "core/online/even_stamps.h"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.h"
#include "core/recording/even_times.h"

namespace heft {

namespace {

constexpr std::size_t kJudged = 100;             // Samples that are judged together,
constexpr Eigen::Index kSettling = 20;           // but for the first of a stretch, in which the clock finds its phase
constexpr double kSteady = 0.2;                  // Of a step
constexpr double kLost = 1.75, kTooEarly = 0.4;  // Steps since the sample before
constexpr int kAgain = 3;

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
  if (step_ <= 0.0 ? std::ssize(recent_) == kSettling : recent_.size() == kJudged) judge();
  return used_ ? recent_.back().even : stamp;
}

void EvenStamps::judge() {
  std::vector<double> steps, off;
  for (std::size_t i = 1; i < recent_.size(); ++i) steps.push_back(recent_[i].stamp - recent_[i - 1].stamp);
  const bool first = step_ <= 0.0;
  step_ = median(steps);
  if (first || recent_.size() < kJudged) return;
  const auto count = static_cast<Eigen::Index>(recent_.size());
  VectorXd stamps(count), even(count);
  MatrixXd motion(count, recent_.front().motion.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const Sample& sample = recent_[static_cast<std::size_t>(i)];
    stamps(i) = sample.stamp;
    even(i) = sample.even;
    motion.row(i) = sample.motion.transpose();
    if (i >= settled_) off.push_back(sample.stamp - sample.even);
  }
  const double asStamped = roughness(stamps, motion, settled_), asEven = roughness(even, motion, settled_);
  const bool before = used_;
  if (robustStd(off) > kSteady * step_ || asStamped < kClearlySmoother * asEven)
    used_ = false;
  else if (asEven < kClearlySmoother * asStamped)
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
