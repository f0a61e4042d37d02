#include "core/live/merger.h"

#include <algorithm>
#include <cmath>

namespace heft {

namespace {

constexpr double kLongest = 2.0;     ///< [s] A part waits so long for its partner.
constexpr double kWidestGap = 0.25;  ///< [s] Across wider gaps nothing is interpolated, unless the streams are so slow.
constexpr double kInertialLate = 0.3;  ///< [s] So far behind, an inertial sensor is not waited for.
constexpr std::size_t kMostWaiting = 40000;

/// Between two samples, `share` of the way to the later one.
LiveSample between(const LiveSample& a, const LiveSample& b, double share) {
  LiveSample out;
  out.time = (1.0 - share) * a.time + share * b.time;
  const auto mix = [&](const std::array<double, 7>& x, const std::array<double, 7>& y) {
    std::array<double, 7> z{};
    for (std::size_t j = 0; j < z.size(); ++j) z[j] = (1.0 - share) * x[j] + share * y[j];
    return z;
  };
  out.joints = a.joints;
  if (a.q && b.q) out.q = mix(*a.q, *b.q);
  if (a.dq && b.dq) out.dq = mix(*a.dq, *b.dq);
  if (a.orientation && b.orientation) out.orientation = a.orientation->slerp(share, *b.orientation);
  if (a.position && b.position) out.position = (1.0 - share) * *a.position + share * *b.position;
  if (a.wrench && b.wrench) out.wrench = (1.0 - share) * *a.wrench + share * *b.wrench;
  if (a.accelerometer && b.accelerometer)
    out.accelerometer = (1.0 - share) * *a.accelerometer + share * *b.accelerometer;
  if (a.gyroscope && b.gyroscope) out.gyroscope = (1.0 - share) * *a.gyroscope + share * *b.gyroscope;
  return out;
}

}  // namespace

bool StreamMerger::take(Lane& lane, const LiveSample& part) {
  if (lane.seen > 0 && part.time <= lane.last) {
    ++late_;
    return false;
  }
  if (lane.seen > 0) {
    const double step = part.time - lane.last;
    // Long pauses are no steps.
    if (lane.step <= 0.0 || step < 10.0 * lane.step) {
      const double gain = std::max(0.02, 1.0 / static_cast<double>(lane.seen));
      lane.step += gain * (step - lane.step);
    }
  }
  lane.last = part.time;
  lane.seen = std::min(lane.seen + 1, 1000000);
  lane.samples.push_back(part);
  return true;
}

std::optional<LiveSample> StreamMerger::matched(const LiveSample& base, const Lane& other, double width,
                                                bool wrenchBase) const {
  const auto& samples = other.samples;
  const auto after = std::lower_bound(samples.begin(), samples.end(), base.time,
                                      [](const LiveSample& sample, double t) { return sample.time < t; });
  if (after == samples.end()) return std::nullopt;
  if (after == samples.begin() && after->time != base.time) return std::nullopt;
  LiveSample found = *after;
  if (after->time != base.time) {
    const auto& before = *(after - 1);
    if (after->time - before.time > std::max(kWidestGap, 5.0 * other.step)) return std::nullopt;
    found = between(before, *after, (base.time - before.time) / (after->time - before.time));
  }
  LiveSample out = wrenchBase ? found : base;
  out.time = base.time;
  out.wrench = wrenchBase ? base.wrench : found.wrench;
  if (!out.accelerometer) {
    const LiveSample& fromOther = wrenchBase ? base : found;
    out.accelerometer = fromOther.accelerometer;
    out.gyroscope = fromOther.gyroscope;
  }
  if (width > 0.0 && !wrenchBase) {  // the wrench is faster: its mean over the motion's step
    Vector6d sum = Vector6d::Zero();
    int count = 0;
    for (auto it = after; it != samples.end() && it->time <= base.time + 0.5 * width; ++it, ++count) sum += *it->wrench;
    for (auto it = after; it != samples.begin() && (it - 1)->time >= base.time - 0.5 * width; --it, ++count)
      sum += *(it - 1)->wrench;
    if (count > 1) out.wrench = sum / count;
  }
  return out;
}

void StreamMerger::release(std::vector<LiveSample>& complete) {
  auto& felt = inertial_.samples;
  while (!waiting_.empty()) {
    LiveSample& next = waiting_.front();
    const double half = released_ > -1e299 ? std::min(0.5 * (next.time - released_), 0.5 * kWidestGap) : 0.0;
    const bool comes = !next.accelerometer && inertial_.seen >= 3;
    if (comes && inertial_.last < next.time + half && waiting_.back().time - inertial_.last < kInertialLate) return;
    const auto after = std::lower_bound(felt.begin(), felt.end(), next.time,
                                        [](const LiveSample& sample, double t) { return sample.time < t; });
    const bool within = comes && after != felt.end() && (after != felt.begin() || after->time == next.time);
    if (within) {
      const LiveSample at =
          after->time == next.time
              ? *after
              : between(*(after - 1), *after, (next.time - (after - 1)->time) / (after->time - (after - 1)->time));
      if (after->time == next.time || after->time - (after - 1)->time <= std::max(kWidestGap, 5.0 * inertial_.step)) {
        next.accelerometer = at.accelerometer;
        next.gyroscope = at.gyroscope;
      }
    }
    if (next.accelerometer && within && inertial_.step < 1.33 * half) {  // it is faster: its mean over the step
      Vector3d acceleration = Vector3d::Zero(), rate = Vector3d::Zero();
      int count = 0;
      bool turning = next.gyroscope.has_value();
      for (const LiveSample& sample : felt) {
        if (std::abs(sample.time - next.time) > half) continue;
        acceleration += *sample.accelerometer;
        turning = turning && sample.gyroscope;
        if (turning) rate += *sample.gyroscope;
        ++count;
      }
      if (count > 1) {
        next.accelerometer = acceleration / count;
        next.gyroscope = turning ? std::optional<Vector3d>(rate / count) : std::nullopt;
      }
    }
    while (felt.size() > 2 && felt[1].time < next.time - kWidestGap) felt.pop_front();
    released_ = next.time;
    complete.push_back(std::move(next));
    waiting_.pop_front();
  }
}

void StreamMerger::emitReady() {
  if (motion_.seen < 3 || wrench_.seen < 3) return;
  const bool wrenchBase = wrench_.step > 1.2 * motion_.step;
  Lane& base = wrenchBase ? wrench_ : motion_;
  Lane& other = wrenchBase ? motion_ : wrench_;
  const double width = other.step < 0.67 * base.step ? base.step : 0.0;
  while (!base.samples.empty() && !other.samples.empty()) {
    const LiveSample& next = base.samples.front();
    if (other.last < next.time + 0.5 * width) return;  // its partner may still come
    const auto found = matched(next, other, width, wrenchBase);
    if (found && found->time > emitted_) {
      waiting_.push_back(*found);
      emitted_ = found->time;
    } else {
      ++unmatched_;
    }
    base.samples.pop_front();
    // Partners before the next base sample's reach are done with.
    const double done = base.last - kLongest;
    const double needed = base.samples.empty() ? emitted_ - width : base.samples.front().time - width;
    while (other.samples.size() > 2 && other.samples[1].time < std::max(needed, done)) other.samples.pop_front();
  }
}

LiveSample StreamMerger::unwrapped(const LiveSample& part) {
  LiveSample out = part;
  if (!out.q) return out;
  const auto joints = static_cast<std::size_t>(std::clamp(part.joints, 0, 7));
  for (std::size_t j = 0; j < joints; ++j) (*out.q)[j] = angles_[j].next((*out.q)[j], part.time - anglesAt_);
  anglesAt_ = part.time;
  return out;
}

std::vector<int> StreamMerger::wrapped() const {
  std::vector<int> out;
  for (std::size_t j = 0; j < angles_.size(); ++j)
    if (angles_[j].jumped()) out.push_back(static_cast<int>(j));
  return out;
}

void StreamMerger::add(const LiveSample& read, std::vector<LiveSample>& complete) {
  if (!std::isfinite(read.time)) return;
  const LiveSample part = unwrapped(read);
  if (part.hasMotion() && part.wrench) {
    if (part.time <= emitted_) {
      ++late_;
      return;
    }
    emitted_ = part.time;
    waiting_.push_back(part);
    release(complete);
    return;
  }
  if (part.hasMotion()) take(motion_, part);
  if (part.wrench) take(wrench_, part);
  if (!part.hasMotion() && !part.wrench && part.accelerometer) take(inertial_, part);
  emitReady();
  release(complete);
  // A source that stays away must not fill the memory.
  for (Lane* lane : {&motion_, &wrench_, &inertial_}) {
    while (!lane->samples.empty() &&
           (lane->samples.front().time < lane->last - kLongest || lane->samples.size() > kMostWaiting)) {
      lane->samples.pop_front();
      unmatched_ += lane == &inertial_ ? 0 : 1;
    }
  }
}

}  // namespace heft
