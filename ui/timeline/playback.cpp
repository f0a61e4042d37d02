#include "ui/timeline/playback.h"

#include <algorithm>
#include <cmath>

namespace heft {

Playback::Playback(QObject* parent) : QObject(parent) {
  timer_.setInterval(33);
  connect(&timer_, &QTimer::timeout, this, &Playback::advance);
}

void Playback::setRange(double lower, double upper, bool poses) {
  setPlaying(false);
  lower_ = lower;
  upper_ = std::max(lower, upper);
  poses_ = poses;
  time_ = lower_;
  loopFrom_ = loopTo_ = 0.0;
  emit timeChanged(time_);
}

void Playback::setTime(double time) {
  if (!std::isfinite(time)) return;
  time = std::clamp(time, lower_, upper_);
  if (time == time_) return;
  time_ = time;
  emit timeChanged(time_);
}

void Playback::setLoop(double from, double to) {
  loopFrom_ = std::clamp(from, lower_, upper_);
  loopTo_ = std::clamp(to, lower_, upper_);
}

void Playback::setPlaying(bool playing) {
  if (playing == timer_.isActive()) return;
  if (playing) {
    if (upper_ <= lower_) return;
    if (time_ >= upper_) setTime(lower_);
    clock_.start();
    timer_.start();
  } else {
    timer_.stop();
  }
  emit playingChanged(playing);
}

void Playback::advance() {
  // By the wall clock, so that a slow frame is skipped instead of slowing the motion down.
  setTime(time_ + speed_ * (poses_ ? 2.0 : 1.0) * static_cast<double>(clock_.restart()) / 1000.0);
  if (loops() && (time_ >= loopTo_ || time_ < loopFrom_)) return setTime(loopFrom_);
  if (time_ >= upper_) setPlaying(false);
}

}  // namespace heft
