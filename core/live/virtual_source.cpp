#include "core/live/virtual_source.h"

#include <algorithm>
#include <chrono>

#include "core/base/say.h"

namespace heft {

Result<std::unique_ptr<VirtualSource>> VirtualSource::create(const RobotModel& robot, const VirtualRigOptions& options,
                                                             Pace pace) {
  if (robot.dof() > 7) return Error{heft::say("The virtual arm has seven joints at most.")};
  auto rig = VirtualRig::create(robot, options);
  if (!rig) return rig.error();
  return std::unique_ptr<VirtualSource>(new VirtualSource(std::move(*rig), pace));
}

VirtualSource::VirtualSource(VirtualRig rig, Pace pace) : rig_(std::move(rig)), pace_(pace) {
  status_.name = "virtual " + rig_.arm().robot().name();
}

VirtualSource::~VirtualSource() { VirtualSource::stop(); }

Result<bool> VirtualSource::start(SampleSink sink) {
  stop();
  const std::lock_guard lock(mutex_);
  sink_ = std::move(sink);
  running_ = true;
  status_.state = LinkState::live;
  origin_ = hostNow() - newest_;
  started_ = newest_;
  owed_ = 0.0;
  if (pace_ == Pace::stepped) return true;
  thread_ = std::jthread([this](const std::stop_token& stopping) {
    double then = hostNow();
    while (!stopping.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
      const double now = hostNow();
      advance(std::min(0.5, now - then));
      then = now;
    }
  });
  return true;
}

void VirtualSource::stop() {
  if (thread_.joinable()) {
    thread_.request_stop();
    thread_.join();
    thread_ = std::jthread();
  }
  const std::lock_guard lock(mutex_);
  running_ = false;
  status_.state = LinkState::idle;
}

SourceStatus VirtualSource::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void VirtualSource::emitNext() {
  const VirtualSample& made = rig_.next();
  newest_ = made.time;
  LiveSample sample;
  sample.time = origin_ + made.time;
  sample.joints = static_cast<int>(made.q.size());
  sample.q.emplace();
  sample.dq.emplace();
  for (std::size_t j = 0; j < static_cast<std::size_t>(sample.joints); ++j) {
    (*sample.q)[j] = made.q(static_cast<Eigen::Index>(j));
    (*sample.dq)[j] = made.dq(static_cast<Eigen::Index>(j));
  }
  sample.wrench = made.wrench;
  ++status_.samples;
  sink_(sample);
}

void VirtualSource::advance(double seconds) {
  const std::lock_guard lock(mutex_);
  if (!running_) return;
  owed_ += seconds;
  // Half a step of slack: sums of seconds are not exact.
  const double step = 1.0 / rig_.options().rateHz;
  for (; owed_ > 0.5 * step; owed_ -= step) emitNext();
}

void VirtualSource::guide(const std::function<void(GuidedArm&)>& act) {
  const std::lock_guard lock(mutex_);
  act(rig_.arm());
}

Result<bool> VirtualSource::changeTool(const Payload& payload) {
  const std::lock_guard lock(mutex_);
  return rig_.changeTool(payload);
}

Payload VirtualSource::payload() const {
  const std::lock_guard lock(mutex_);
  return rig_.options().payload;
}

double VirtualSource::elapsed() const {
  const std::lock_guard lock(mutex_);
  return newest_ - started_;
}

}  // namespace heft
