#include "core/live/session.h"

#include <algorithm>
#include <numbers>

#include "core/base/say.h"

namespace heft {

std::string missingPart(const SessionStatus& status) {
  if (status.motions > 0 && status.wrenches > 0) return {};
  if (status.motions == 0 && status.wrenches == 0)
    return heft::say("Neither joint angles, a pose nor a wrench arrived: motion and wrench are both needed.");
  if (status.motions == 0)
    return heft::say(
        "The wrench arrives, but no joint angles and no pose: add the robot as a second source, such as "
        "foxglove:HOST, rosbridge:HOST or rtde:HOST.");
  return heft::say("Joint angles or poses arrive, but no wrench: add the sensor as a second source, such as rdt:HOST.");
}

void SampleQueue::push(const LiveSample& sample) {
  if (samples_.size() >= capacity_)
    samples_.erase(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(capacity_ / 10 + 1));
  samples_.push_back(sample);
  ++total_;
}

void SampleQueue::takeAll(std::vector<LiveSample>& out) {
  out.clear();
  out.swap(samples_);
}

LiveSession::LiveSession(std::size_t queueCapacity) : queue_(queueCapacity) {}

LiveSession::~LiveSession() { stop(); }

void LiveSession::addSource(std::unique_ptr<LiveSource> source) { sources_.push_back(std::move(source)); }

void LiveSession::setConventions(const Conventions& conventions) {
  const std::lock_guard lock(mutex_);
  merger_.setTurn(2.0 * std::numbers::pi / conventions.radPerAngle);
}

Result<bool> LiveSession::start() {
  for (const auto& source : sources_) {
    auto started = source->start([this](const LiveSample& part) { take(part); });
    if (started) continue;
    stop();
    return started;
  }
  return true;
}

void LiveSession::stop() {
  for (const auto& source : sources_) source->stop();
  const std::lock_guard lock(mutex_);
  if (recorder_) recorder_->flush();
}

void LiveSession::take(const LiveSample& part) {
  const std::lock_guard lock(mutex_);
  if (part.hasMotion()) ++motions_;
  if (part.wrench) ++wrenches_;
  complete_.clear();
  merger_.add(part, complete_);
  if (paused_) return;
  for (const auto& sample : complete_) {
    queue_.push(sample);
    newest_ = sample.time;
    if (recorder_) recorder_->add(sample);
  }
}

void LiveSession::setPaused(bool paused) {
  const std::lock_guard lock(mutex_);
  paused_ = paused;
}

Result<bool> LiveSession::record(const std::filesystem::path& csv, const RecordingMeta& meta) {
  auto made = Recorder::create(csv, meta);
  if (!made) return made.error();
  const std::lock_guard lock(mutex_);
  recorder_.emplace(std::move(*made));
  return true;
}

std::uint64_t LiveSession::endRecording() {
  const std::lock_guard lock(mutex_);
  const auto rows = recorder_ ? recorder_->rows() : 0;
  recorder_.reset();
  return rows;
}

SessionStatus LiveSession::status() const {
  SessionStatus out;
  for (const auto& source : sources_) out.sources.push_back(source->status());
  const std::lock_guard lock(mutex_);
  out.samples = queue_.total();
  out.motions = motions_;
  out.wrenches = wrenches_;
  out.late = merger_.late();
  out.unmatched = merger_.unmatched();
  out.recorded = recorder_ ? recorder_->rows() : 0;
  if (recorder_) out.recordingProblem = recorder_->problem();
  out.newest = newest_;
  out.wrapped = merger_.wrapped();
  return out;
}

void LiveSession::takeNew(std::vector<LiveSample>& out) {
  const std::lock_guard lock(mutex_);
  queue_.takeAll(out);
}

}  // namespace heft
