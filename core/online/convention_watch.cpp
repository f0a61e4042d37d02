#include "core/online/convention_watch.h"

#include <chrono>
#include <utility>
#include <vector>

#include "core/motion/motion.h"

namespace heft {

namespace {

constexpr double kFirstAsked = 5.0, kLooksBack = 60.0;  // [s]
constexpr double kAskedAgain = 1.5;                     // Times the time of the last question
/// A tie is worth a word only where a motion of this length did not decide it [s].
constexpr double kTieAfter = 20.0;
/// What hands do is below 6 Hz, and the check averages over 80 ms.
constexpr double kWatchedHz = 250.0;

conventions::Report answerOf(const std::deque<OnlineSample>& samples, const RecordingMeta& meta,
                             const RobotModel* robot) {
  const Recording recording = recordingOf(samples, meta, robot ? robot->dof() : 0);
  const auto motion = motionOf(recording, robot, {});
  return motion ? conventions::check(conventions::questionOf(recording, *motion)) : conventions::Report{};
}

}  // namespace

Recording recordingOf(const std::deque<OnlineSample>& samples, const RecordingMeta& meta, int dof) {
  Recording out;
  out.meta = meta;
  if (samples.empty()) return out;
  const OnlineSample& first = samples.front();
  const bool poses = first.pose.has_value(), positions = poses && first.pose->position.has_value();
  std::vector<const OnlineSample*> rows;
  for (const OnlineSample& sample : samples)
    if (poses ? sample.pose && (!positions || sample.pose->position) : sample.q.has_value()) rows.push_back(&sample);
  const auto count = static_cast<Eigen::Index>(rows.size());
  out.time.resize(count);
  out.wrench.resize(count, 6);
  if (poses) out.quaternion.resize(count, 4);
  if (positions) out.position.resize(count, 3);
  if (!poses) out.q.resize(count, dof);
  for (Eigen::Index k = 0; k < count; ++k) {
    const OnlineSample& sample = *rows[static_cast<std::size_t>(k)];
    out.time(k) = sample.time;
    out.wrench.row(k) = sample.wrench.transpose();
    if (poses) out.quaternion.row(k) = sample.pose->orientation.normalized().coeffs().transpose();
    if (positions) out.position.row(k) = sample.pose->position->transpose();
    if (!poses) out.q.row(k) = Eigen::Map<const VectorXd>(sample.q->data(), dof).transpose();
  }
  return out;
}

ConventionWatch::ConventionWatch(RecordingMeta meta, const RobotModel* robot)
    : meta_(std::move(meta)), robot_(robot ? std::make_shared<const RobotModel>(*robot) : nullptr) {}

void ConventionWatch::add(const OnlineSample& sample) {
  if (sample.pose ? !sample.pose->position.has_value() : !sample.q || !robot_) return;
  if (samples_.empty() && askAt_ == 0.0) {
    first_ = sample.time;
    askAt_ = kFirstAsked;
  }
  if (!sample.wrench.allFinite()) return;
  if (!samples_.empty() && sample.time < samples_.back().time + 0.9 / kWatchedHz) return;
  samples_.push_back(sample);
  while (sample.time - samples_.front().time > kLooksBack) samples_.pop_front();
  if (sample.time - first_ < askAt_ || asked_.valid()) return;
  askAt_ = kAskedAgain * (sample.time - first_);
  asked_ = std::async(std::launch::async, [samples = samples_, meta = meta_, robot = robot_] {
    return answerOf(samples, meta, robot.get());
  });
}

bool ConventionWatch::news(bool wait) {
  if (!asked_.valid() || (!wait && asked_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)) return false;
  using conventions::Verdict;
  conventions::Report now = asked_.get();
  const bool tells = now.verdict == Verdict::suggested ||
                     (now.verdict == Verdict::ambiguous && samples_.back().time - first_ > kTieAfter);
  const bool told = report_.has_value();
  const std::string before = told ? report_->sentence : std::string();
  report_.reset();
  if (tells) report_ = std::move(now);
  return tells != told || (tells && report_->sentence != before);
}

}  // namespace heft
