#include "core/online/sample_stream.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/spikes.h"
#include "core/math/statistics.h"
#include "core/motion/resample.h"

namespace heft {

namespace {

constexpr double kRateTime = 0.25;         // [s] of samples that tell the rate,
constexpr std::size_t kRateCount = 9;      // but at least so many
constexpr double kMostOfMean = 5.0;        // Times the mean rate, where most samples were lost
constexpr double kGap = 0.05;              // [s] between two samples that ends a stretch,
constexpr double kGapSteps = 5.0;          // or so many steps
constexpr std::size_t kSpikeWindow = 300;  // samples that tell what is usual

bool finite(const std::array<double, 7>& values, int count) {
  return std::all_of(values.begin(), values.begin() + count, [](double v) { return std::isfinite(v); });
}

}  // namespace

SampleStream::SampleStream(const RecordingMeta& meta, int dof) : meta_(meta), dof_(dof) {
  meta_.marks.clear();
  meta_.kind = RecordingKind::motion;
}

bool SampleStream::usable(const OnlineSample& s) const {
  if (!std::isfinite(s.time) || !s.wrench.allFinite()) return false;
  if (s.pose) {
    if (!(s.pose->orientation.norm() > 0.5 && s.pose->orientation.norm() < 2.0)) return false;
    if (s.pose->position && !s.pose->position->allFinite()) return false;
  } else if (!(s.q && dof_ > 0 && finite(*s.q, dof_))) {
    return false;
  }
  if (s.dq && !finite(*s.dq, dof_)) return false;
  if (samples_.empty()) return true;
  const OnlineSample& last = samples_.back();
  if (!(s.time > newestStamp_)) return false;
  if (s.pose.has_value() != last.pose.has_value()) return false;
  if (s.pose) return s.pose->position.has_value() == last.pose->position.has_value();
  return s.dq.has_value() == last.dq.has_value();
}

Took SampleStream::add(const OnlineSample& sample) {
  if (!usable(sample)) return Took::dropped;
  if (!samples_.empty()) {
    double gap = kGap;
    if (rateHz_ > 0.0)
      gap = std::max(gap, kGapSteps / rateHz_);
    else if (samples_.size() > 1)
      gap = std::max(gap, kGapSteps * (samples_[1].time - samples_[0].time));
    else
      gap = 1.0;
    if (sample.time - samples_.back().time > gap) return Took::gap;
  } else {
    startTime_ = sample.time;
    first_ = cleaned_ = 0;
  }
  samples_.push_back(sample);
  if (auto& pose = samples_.back().pose) {
    pose->orientation.normalize();
    if (samples_.size() > 1 &&
        pose->orientation.coeffs().dot(samples_[samples_.size() - 2].pose->orientation.coeffs()) < 0.0)
      pose->orientation.coeffs() *= -1.0;
  }
  newestStamp_ = sample.time;
  setTimes();
  if (rateHz_ == 0.0) findRate();
  return Took::yes;
}

void SampleStream::setTimes() {
  constexpr double kLeast = 1e-6;  // [s] between two samples
  OnlineSample& newest = samples_.back();
  VectorXd motion(newest.pose ? (newest.pose->position ? 7 : 4) : dof_);
  if (newest.pose) {
    motion.head<4>() = newest.pose->orientation.coeffs();
    if (newest.pose->position) motion.tail<3>() = *newest.pose->position;
  } else {
    motion = Eigen::Map<const VectorXd>(newest.q->data(), dof_);
  }
  newest.time = even_.timeOf(newest.time, std::move(motion));
  const std::vector<double> corrected = even_.corrected();
  const std::size_t count = std::max<std::size_t>(1, std::min(corrected.size(), samples_.size()));
  for (std::size_t i = samples_.size() - count; i < samples_.size(); ++i) {
    if (!corrected.empty()) samples_[i].time = corrected[corrected.size() - (samples_.size() - i)];
    if (i > 0) samples_[i].time = std::max(samples_[i].time, samples_[i - 1].time + kLeast);
  }
  if (first_ == 0 && count == samples_.size()) startTime_ = samples_.front().time;
}

void SampleStream::clear() {
  even_.beginStretch();
  samples_.clear();
  first_ = cleaned_ = 0;
}

void SampleStream::findRate() {
  if (samples_.size() < kRateCount || samples_.back().time - samples_.front().time < kRateTime) return;
  VectorXd time(static_cast<Eigen::Index>(samples_.size()));
  for (std::size_t i = 0; i < samples_.size(); ++i) time(static_cast<Eigen::Index>(i)) = samples_[i].time;
  rateHz_ = gridFor(time).rateHz;
  // Stamped in bursts: most steps are next to nothing, and the grid would have thousands of rows a sample.
  const double mean = static_cast<double>(time.size() - 1) / (time(time.size() - 1) - time(0));
  if (rateHz_ > kMostOfMean * mean) rateHz_ = mean;
  // Clocks are set to whole hertz; jitter and rounded time stamps hide it.
  if (const double whole = std::round(rateHz_); whole >= 10.0 && std::abs(rateHz_ - whole) < 0.003 * whole)
    rateHz_ = whole;
}

Eigen::Index SampleStream::size() const {
  if (samples_.empty() || !ready()) return 0;
  return static_cast<Eigen::Index>(std::floor((samples_.back().time - startTime_) * rateHz_ + 1e-3)) + 1;
}

Recording SampleStream::window(Eigen::Index from, Eigen::Index to) const {
  // Samples that hold the window, with three more on both sides for interpolation.
  const auto at = [this](Eigen::Index k) { return startTime_ + static_cast<double>(k) / rateHz_; };
  const double tolerance = 0.01 / rateHz_;
  const auto byTime = [](const OnlineSample& s, double t) { return s.time < t; };
  auto begin = std::lower_bound(samples_.begin(), samples_.end(), at(from) - tolerance, byTime);
  auto end = std::lower_bound(begin, samples_.end(), at(to - 1) + tolerance, byTime);
  UniformGrid grid{at(from), rateHz_, to - from, end - begin == to - from};
  for (Eigen::Index k = from; grid.exact && k < to; ++k)
    grid.exact = std::abs((begin + (k - from))->time - at(k)) < tolerance;
  if (!grid.exact) {
    begin -= std::min<std::ptrdiff_t>(3, begin - samples_.begin());
    end += std::min<std::ptrdiff_t>(3, samples_.end() - end);
  }

  const Eigen::Index n = end - begin;
  const bool poses = begin->pose.has_value();
  const bool position = poses && begin->pose->position.has_value();
  const bool velocities = !poses && begin->dq.has_value();
  VectorXd time(n);
  MatrixXd wrench(n, 6), q(poses ? 0 : n, dof_), dq(velocities ? n : 0, dof_), p(position ? n : 0, 3),
      orientation(poses ? n : 0, 4);
  Eigen::Index i = 0;
  for (auto s = begin; s != end; ++s, ++i) {
    time(i) = s->time;
    wrench.row(i) = s->wrench.transpose();
    for (int j = 0; !poses && j < dof_; ++j) {
      q(i, j) = (*s->q)[static_cast<std::size_t>(j)];
      if (velocities) dq(i, j) = (*s->dq)[static_cast<std::size_t>(j)];
    }
    if (poses) orientation.row(i) = s->pose->orientation.coeffs().transpose();
    if (position) p.row(i) = s->pose->position->transpose();
  }

  Recording out;
  out.meta = meta_;
  out.time.resize(grid.size);
  for (Eigen::Index k = 0; k < grid.size; ++k) out.time(k) = at(from + k);
  out.wrench = onGrid(grid, time, wrench);
  if (poses) {
    out.quaternion = onGrid(grid, time, orientation);
    out.quaternion.rowwise().normalize();
    if (position) out.position = onGrid(grid, time, p);
  } else {
    out.q = onGrid(grid, time, q);
    if (velocities) out.dq = onGrid(grid, time, dq);
  }
  return out;
}

void SampleStream::removeSpikes() {
  const std::uint64_t end = first_ + samples_.size();
  if (end < cleaned_ + 8 || samples_.size() < 30) return;
  const std::uint64_t wanted = cleaned_ > kSpikeWindow ? cleaned_ - kSpikeWindow : 0;
  const auto from = static_cast<std::size_t>(std::max(wanted, first_) - first_);
  const auto n = static_cast<Eigen::Index>(samples_.size() - from);
  Eigen::Matrix<double, Eigen::Dynamic, 6> wrench(n, 6);
  for (Eigen::Index i = 0; i < n; ++i) wrench.row(i) = samples_[from + static_cast<std::size_t>(i)].wrench.transpose();
  Eigen::Index replaced = 0;
  const auto clean = withoutSpikes(wrench, replaced);
  for (Eigen::Index i = 0; replaced > 0 && i + 3 < n; ++i)
    samples_[from + static_cast<std::size_t>(i)].wrench = clean.row(i).transpose();
  cleaned_ = end - 3;
}

void SampleStream::forget(Eigen::Index from) {
  const double before = startTime_ + static_cast<double>(from - 4) / rateHz_;
  while (samples_.size() > 4 && samples_.front().time < before) {
    samples_.pop_front();
    ++first_;
  }
}

}  // namespace heft
