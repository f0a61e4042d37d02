#include "core/recording/clock.h"

#include <algorithm>
#include <cmath>

namespace heft {

double SequenceClock::timeOf(std::int64_t sequence, double arrival) {
  constexpr double kLost = 0.2;  // [s] The device was restarted, or the host slept.
  if (!started_ || sequence <= sequence_) {
    started_ = true;
    seen_ = 0;
    sequence_ = sequence;
    time_ = arrival;
    return time_;
  }
  const auto steps = static_cast<double>(sequence - sequence_);
  if (period_ <= 0.0) period_ = std::max((arrival - time_) / steps, 1e-5);
  const double predicted = time_ + period_ * steps;
  const double error = arrival - predicted;
  sequence_ = sequence;
  if (std::abs(error) > kLost) {
    time_ = arrival;
    seen_ = 0;
    return time_;
  }
  // At first the line through all arrivals, as the expanding memory filter of first degree has it (Morrison 1969);
  // later one that follows slowly: the gain falls to a hundredth.
  const double n = static_cast<double>(++seen_), all = (n + 1.0) * (n + 2.0);
  const double gain = std::max(0.01, 2.0 * (2.0 * n + 1.0) / all);
  const double slope = std::max(0.25 * 0.01 * 0.01, 6.0 / all);
  const double before = time_;
  time_ = predicted + gain * error;
  period_ = std::max(period_ + slope * error / steps, 1e-5);
  time_ = std::max(time_, before + 1e-6);
  return time_;
}

double StampClock::timeOf(double stamp, double arrival) {
  constexpr double kJump = 5.0;  // [s] The sender's clock was set.
  const double delay = arrival - stamp;
  if (seen_ >= kLessons && std::abs(delay - delay_) > kJump) {
    seen_ = 0;
    delay_ = std::numeric_limits<double>::infinity();
  }
  if (seen_ < kLessons) {
    ++seen_;
    delay_ = std::min(delay_, delay);
    return std::numeric_limits<double>::quiet_NaN();
  }
  return stamp + delay_;
}

}  // namespace heft
