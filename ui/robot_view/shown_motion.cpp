#include "ui/robot_view/shown_motion.h"

#include <cmath>
#include <limits>

#include "ui/robot_view/posed_arm.h"

namespace heft {
namespace {

/// In a recording longer than kWholePath [s] the whole path would be an illegible ball: only kPathReach [s] before and
/// after the instant shown are drawn, and redrawn once the instant has moved by kPathStep [s].
constexpr double kWholePath = 60.0, kPathReach = 15.0, kPathStep = 2.0;

MarkLabel labelAt(const std::vector<Segment>& segments, double time) {
  for (const Segment& segment : segments) {
    if (time >= segment.from && time <= segment.to) return segment.label;
  }
  return MarkLabel::free;
}

}  // namespace

ShownMotion::ShownMotion(std::shared_ptr<const Recording> recording, std::shared_ptr<const RobotModel> robot)
    : recording_(std::move(recording)), robot_(std::move(robot)), track_(recording_, robot_) {}

ShownMotion::~ShownMotion() = default;

double ShownMotion::firstTime() const {
  if (recording_->meta.kind == RecordingKind::poses) return 1.0;
  return recording_->rows() > 0 ? recording_->time(0) : 0.0;
}

double ShownMotion::span() const {
  return recording_->meta.kind == RecordingKind::poses ? static_cast<double>(recording_->rows() - 1)
                                                       : recording_->duration();
}

bool ShownMotion::follow(const std::shared_ptr<const RobotModel>& robot) {
  posed_.reset();
  if (track_.hasJoints() || robot_ || !recording_->hasOrientation()) return false;
  auto arm = PosedArm::follow(track_, recording_->meta.mount, firstTime(), firstTime() + span(), robot);
  if (arm) posed_ = std::make_unique<PosedArm>(std::move(*arm));
  return standsIn();
}

std::vector<Isometry3d> ShownMotion::linksAt(double time) const {
  std::vector<Isometry3d> X_BL;
  if (posed_)
    posed_->robot().linkPoses(posed_->jointsAt(time), X_BL);
  else if (track_.hasJoints())
    robot_->linkPoses(track_.jointsAt(time), X_BL);
  return X_BL;
}

std::vector<PathSample> ShownMotion::path(double time, const std::vector<Segment>& segments) const {
  const bool whole = recording_->duration() <= kWholePath;
  const double reach = whole ? std::numeric_limits<double>::infinity() : kPathReach;
  std::vector<PathSample> samples;
  for (const auto& point : track_.path(time - reach, time + reach, 1500))
    samples.push_back({point.p_BSo_B, labelAt(segments, point.time)});
  return samples;
}

bool ShownMotion::pathHolds(double shownAbout, double time) const {
  return std::abs(time - shownAbout) <= kPathStep || recording_->duration() <= kWholePath;
}

std::vector<Vector3d> ShownMotion::sweep() const {
  std::vector<Vector3d> points;
  constexpr int kInstantsOfSweep = 40;
  for (int i = 0; i <= kInstantsOfSweep; ++i) {
    const double time = firstTime() + span() * i / kInstantsOfSweep;
    for (const Isometry3d& X : linksAt(time)) {
      // A link is about this thick about its frame.
      for (const double side : {-0.09, 0.09}) {
        for (int axis = 0; axis < 3; ++axis) points.push_back(X.translation() + side * Vector3d::Unit(axis));
      }
    }
    const Vector3d sensor = track_.sensorAt(time).translation();
    points.push_back(sensor - Vector3d(0, 0, 0.25));
    points.push_back(sensor + Vector3d(0, 0, 0.2));
  }
  return points;
}

}  // namespace heft
