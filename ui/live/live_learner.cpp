#include "ui/live/live_learner.h"

#include <algorithm>
#include <cmath>

#include "core/motion/motion.h"
#include "core/online/online_information.h"
#include "core/wrench/regressor.h"

namespace heft {
namespace {

constexpr double kKept = 2.5;           ///< [s] of samples for the simulated wrench
constexpr double kSimulateEvery = 0.4;  ///< [s]
constexpr double kEdge = 0.3;           ///< [s] at the ends of a segment, where smoothing is worst
constexpr std::size_t kMostKnown = 400, kMostPath = 1500, kMostTouched = 200;
constexpr double kShortestTouch = 0.1;  ///< [s]
constexpr double kNoticed = 0.6;        ///< [s] A touch is noticed about so late.

/// Drops every other entry once there are too many; true if it did.
template <class T>
bool halve(std::vector<T>& values, std::size_t most) {
  if (values.size() <= most) return false;
  for (std::size_t i = 0; 2 * i < values.size(); ++i) values[i] = values[2 * i];
  values.resize((values.size() + 1) / 2);
  return true;
}

KnownSoFar knownSoFar(const OnlineState& state) {
  KnownSoFar known;
  known.time = state.time;
  known.mass = 1.96 * state.std.mass;
  known.com = 1.96 * state.std.com.maxCoeff();
  for (int i = 0; i < 3; ++i)
    known.inertia = std::max(
        known.inertia, 1.96 * state.std.inertiaCom(i, i) / std::max(1e-9, std::abs(state.payload.inertiaCom(i, i))));
  return known;
}

}  // namespace

Result<std::shared_ptr<LiveLearner>> LiveLearner::create(const LearnerSetup& setup) {
  OnlineOptions options;
  options.shape = setup.shape;
  auto estimator = OnlineEstimator::create(setup.meta, setup.robot.get(), options);
  if (!estimator) return estimator.error();
  std::optional<GuidedTool> tool;
  if (setup.robot) {
    auto made = guidedTool(*setup.robot, setup.meta.mount);
    if (!made) return made.error();
    tool = std::move(*made);
  }
  auto plain = PlainSamples::create(setup.meta, setup.robot.get());
  if (!plain) return plain.error();
  return std::shared_ptr<LiveLearner>(new LiveLearner(setup, std::move(*plain), std::move(*estimator), tool));
}

LiveLearner::LiveLearner(const LearnerSetup& setup, PlainSamples plain, OnlineEstimator estimator,
                         const std::optional<GuidedTool>& tool)
    : setup_(setup),
      plain_(std::move(plain)),
      estimator_(std::move(estimator)),
      watch_(setup.meta, setup.robot.get()),
      tool_(tool),
      guide_(tool, setup.meta.gravity) {}

Isometry3d LiveLearner::poseOf(const OnlineSample& sample) const {
  Isometry3d X_BS = Isometry3d::Identity();
  if (sample.pose) {
    X_BS.linear() = sample.pose->orientation.normalized().toRotationMatrix();
    X_BS.translation() = sample.pose->position.value_or(Vector3d(0.4, 0.0, 0.5));
  } else if (sample.q && tool_) {
    X_BS = setup_.robot->linkPose(Eigen::Map<const VectorXd>(sample.q->data(), setup_.robot->dof()), tool_->link) *
           tool_->X_LS;
  }
  return X_BS;
}

void LiveLearner::add(const LiveSample& read) {
  if (!read.wrench || !read.hasMotion()) return;
  const auto plain = plain_.plain(read);
  if (!plain) {
    problem_ = plain.error().message;
    return;
  }
  const LiveSample& sample = *plain;
  if (!start_) start_ = sample.time;
  OnlineSample now;
  now.time = sample.time - *start_;
  now.q = sample.q;
  now.dq = sample.dq;
  if (sample.orientation) now.pose = OnlineSample::Pose{sample.position, *sample.orientation};
  now.wrench = *sample.wrench;
  if (!now.wrench.allFinite() || (!newest_.empty() && now.time <= newest_.back().time)) return;
  note(now);
  if (setup_.poses) {
    if (guide_.add(now))
      next_ = sample.q && tool_ ? nextFrom(Eigen::Map<const VectorXd>(sample.q->data(), setup_.robot->dof()))
                                : std::nullopt;
    return;
  }
  watch_.add(now);
  watch_.news();
  if (estimator_.add(now)) {
    const OnlineState& state = estimator_.state();
    if (state.estimated && now.time - lastKnown_ >= knownStep_) {
      lastKnown_ = now.time;
      known_.push_back(knownSoFar(state));
      if (halve(known_, kMostKnown)) knownStep_ *= 2.0;
    }
    const bool touching = state.touch == Touch::contact;
    if (touching && !touching_) {
      Segment segment;
      // It shows only once the smoothing has seen it.
      segment.from = std::max(touched_.empty() ? 0.0 : touched_.back().to, now.time - kNoticed);
      segment.to = now.time;
      segment.label = MarkLabel::contact;
      touched_.push_back(segment);
    }
    if (touching && !touched_.empty()) touched_.back().to = now.time;
    if (!touching && touching_ && !touched_.empty() &&
        touched_.back().to - touched_.back().from < kNoticed + kShortestTouch)
      touched_.pop_back();
    if (touched_.size() > kMostTouched) touched_.erase(touched_.begin());
    touching_ = touching;
  }
  if (now.time - triedAt_ >= kSimulateEvery) {
    triedAt_ = now.time;
    simulate();
  }
}

void LiveLearner::note(const OnlineSample& sample) {
  newest_.push_back(sample);
  while (sample.time - newest_.front().time > kKept) newest_.pop_front();
  history_.addMeasured(sample.time, sample.wrench);
  if (sample.time - lastPath_ < pathStep_) return;
  lastPath_ = sample.time;
  path_.push_back(poseOf(sample).translation());
  if (halve(path_, kMostPath)) pathStep_ *= 2.0;
}

/// What the present estimate expects of the newest seconds. Once drawn it stays: what the plot shows is what Heft
/// expected when it happened.
void LiveLearner::simulate() {
  const OnlineState& state = estimator_.state();
  if (!state.estimated || newest_.size() < 50 || newest_.back().time - newest_.front().time < 3 * kEdge) return;
  // 400 a second are enough to draw.
  const double span = newest_.back().time - newest_.front().time;
  const auto stride =
      static_cast<std::size_t>(std::max(1.0, std::floor(static_cast<double>(newest_.size()) / span / 400.0)));
  std::deque<OnlineSample> drawn;
  for (std::size_t k = 0; k < newest_.size(); k += stride) drawn.push_back(newest_[k]);
  const Recording recording = recordingOf(drawn, setup_.meta, setup_.robot ? setup_.robot->dof() : 0);
  MotionOptions options;
  options.cutoffHz = state.cutoffHz;
  const auto motion = motionOf(recording, setup_.robot.get(), options);
  if (!motion) return;
  const Vector10d phi = toParameters(state.payload);
  const double until = newest_.back().time - kEdge;
  const double from = std::max(simulatedUpTo_, newest_.front().time + kEdge);
  for (Eigen::Index k = 0; k < motion->size(); ++k) {
    const double t = motion->time(k);
    if (t <= from || t > until) continue;
    const Regressor Y = regressor({motion->specificForce.col(k), motion->omega.col(k), motion->alpha.col(k)});
    const Vector6d simulated = Y * phi + state.bias;
    history_.addSimulated(t, simulated, motion->wrench.col(k) - simulated);
    simulatedUpTo_ = t;
  }
}

LiveView LiveLearner::view() {
  LiveView view;
  view.problem = problem_;
  if (newest_.empty()) return view;
  view.any = true;
  const OnlineSample& last = newest_.back();
  view.time = last.time;
  const double span = last.time - newest_.front().time;
  if (span > 0.2) view.rateHz = static_cast<double>(newest_.size() - 1) / span;
  if (last.q && setup_.robot) view.q = Eigen::Map<const VectorXd>(last.q->data(), setup_.robot->dof());
  view.X_BS = poseOf(last);
  int averaged = 0;
  for (auto sample = newest_.rbegin(); sample != newest_.rend() && last.time - sample->time < 0.02; ++sample) {
    view.wrench += sample->wrench;
    ++averaged;
  }
  view.wrench /= std::max(1, averaged);
  view.state = estimator_.state();
  if (watch_.report()) view.conventions = *watch_.report();
  view.known = known_;
  view.path = path_;
  view.touched = touched_;
  if (auto information = estimator_.information()) {
    view.information = std::make_shared<const OnlineInformation>(std::move(*information));
  }
  view.traces = history_.traces();
  view.poses = guide_.poses();
  view.poseResult = guide_.result();
  if (setup_.poses && !next_ && view.q) next_ = nextFrom(*view.q);
  view.next = next_;
  view.posesWanted = guide_.options().wanted;
  return view;
}

std::optional<NextPose> LiveLearner::nextFrom(const VectorXd& q) const {
  return guide_.next(q, setup_.around ? setup_.around->clearance() : nullptr);
}

void LiveLearner::removePose(std::size_t index) {
  guide_.remove(index);
  next_.reset();
}

Recording recordingOf(const std::vector<JudgedPose>& poses, const RecordingMeta& meta) {
  Recording out;
  out.meta = meta;
  out.meta.kind = RecordingKind::poses;
  out.meta.numbersArePlain();
  std::vector<const StandingPose*> rows;
  for (const JudgedPose& pose : poses)
    if (pose.light == PoseLight::used) rows.push_back(&pose.pose);
  const auto count = static_cast<Eigen::Index>(rows.size());
  const bool joints = count > 0 && rows[0]->q.size() > 0;
  out.time.resize(count);
  out.wrench.resize(count, 6);
  if (joints) out.q.resize(count, rows[0]->q.size());
  if (!joints) out.quaternion.resize(count, 4);
  for (Eigen::Index k = 0; k < count; ++k) {
    const StandingPose& pose = *rows[static_cast<std::size_t>(k)];
    out.time(k) = pose.time;
    out.wrench.row(k) = pose.wrench.transpose();
    if (joints) out.q.row(k) = pose.q.transpose();
    if (!joints) out.quaternion.row(k) = Quaterniond(pose.R_BS).coeffs().transpose();
  }
  return out;
}

}  // namespace heft
