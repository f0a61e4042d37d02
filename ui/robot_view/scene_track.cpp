#include "ui/robot_view/scene_track.h"

#include <algorithm>
#include <cmath>

namespace heft {
namespace {

/// Where a sensor of unknown position is drawn [m]: in front of the base, at table height.
const Vector3d kRestingPoint{0.45, 0.0, 0.45};

Quaterniond quaternionAt(const Recording& recording, Eigen::Index row) {
  const auto q = recording.quaternion.row(row);
  return Quaterniond(q(3), q(0), q(1), q(2)).normalized();
}

}  // namespace

SceneTrack::SceneTrack(std::shared_ptr<const Recording> recording, std::shared_ptr<const RobotModel> robot)
    : recording_(std::move(recording)),
      robot_(std::move(robot)),
      poses_(recording_->meta.kind == RecordingKind::poses) {
  const SensorMount& mount = recording_->meta.mount;
  X_LS_ = poseFromXyzRpy(mount.xyz, mount.rpy);
  if (robot_ && recording_->q.cols() != robot_->dof()) robot_.reset();
  if (robot_) mountLink_ = robot_->findLink(mount.parent).value_or(static_cast<int>(robot_->links().size()) - 1);
}

SceneTrack::Place SceneTrack::placeOf(double time) const {
  const Eigen::Index rows = recording_->rows();
  if (rows < 2) return {0, 0.0};
  if (poses_) return {std::clamp<Eigen::Index>(std::lround(time) - 1, 0, rows - 1), 0.0};
  const double* begin = recording_->time.data();
  const double* after = std::upper_bound(begin, begin + rows, time);
  const Eigen::Index before = std::clamp<Eigen::Index>(after - begin - 1, 0, rows - 2);
  const double step = begin[before + 1] - begin[before];
  return {before, step > 0 ? std::clamp((time - begin[before]) / step, 0.0, 1.0) : 0.0};
}

VectorXd SceneTrack::jointsAt(double time) const {
  if (!hasJoints()) return {};
  const Place place = placeOf(time);
  VectorXd q = recording_->q.row(place.before);
  if (place.share > 0) q += place.share * (recording_->q.row(place.before + 1).transpose() - q);
  return q;
}

Isometry3d SceneTrack::sensorAtRow(Eigen::Index row) const {
  if (hasJoints()) return robot_->linkPose(recording_->q.row(row).transpose(), mountLink_) * X_LS_;
  Isometry3d X_BS = Isometry3d::Identity();
  if (recording_->hasOrientation() && row < recording_->quaternion.rows()) {
    X_BS.linear() = quaternionAt(*recording_, row).toRotationMatrix();
  }
  X_BS.translation() = kRestingPoint;
  if (recording_->hasPosition()) X_BS.translation() = recording_->position.row(row).transpose();
  return X_BS;
}

Isometry3d SceneTrack::sensorAt(double time) const {
  if (hasJoints()) return robot_->linkPose(jointsAt(time), mountLink_) * X_LS_;
  const Place place = placeOf(time);
  Isometry3d X_BS = sensorAtRow(place.before);
  if (place.share > 0) {
    const Isometry3d next = sensorAtRow(place.before + 1);
    const Quaterniond from(X_BS.linear()), to(next.linear());
    X_BS.translation() += place.share * (next.translation() - X_BS.translation());
    X_BS.linear() = from.slerp(place.share, to).toRotationMatrix();
  }
  return X_BS;
}

Vector6d SceneTrack::wrenchAt(double time) const {
  const Place place = placeOf(time);
  if (place.before >= recording_->wrench.rows()) return Vector6d::Zero();
  return recording_->wrench.row(place.before + (place.share > 0.5 ? 1 : 0)).transpose();
}

std::vector<SceneTrack::PathPoint> SceneTrack::path(double from, double to, int most) const {
  std::vector<PathPoint> points;
  if (!positionKnown() || poses_ || most < 2) return points;
  const double* const times = recording_->time.data();
  const double* const end = times + recording_->rows();
  const Eigen::Index first = std::lower_bound(times, end, from) - times;
  const Eigen::Index rows = std::upper_bound(times, end, to) - times - first;
  const Eigen::Index count = std::min<Eigen::Index>(rows, most);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index row = first + (count > 1 ? k * (rows - 1) / (count - 1) : 0);
    points.push_back({sensorAtRow(row).translation(), recording_->time(row)});
  }
  return points;
}

}  // namespace heft
