#include "core/live/plain_samples.h"

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/motion/mount_link.h"

namespace heft {

PlainSamples::PlainSamples(const RecordingMeta& meta) : meta_(meta), form_(meta) {}

Result<PlainSamples> PlainSamples::create(const RecordingMeta& meta, const RobotModel* robot) {
  PlainSamples out(meta);
  if (!meta.conventions.needPose() || robot == nullptr) return out;
  const auto link = mountLink(meta.mount, *robot);
  if (!link) return link.error();
  out.link_ = *link;
  out.robot_ = *robot;
  return out;
}

/// X_BS, as toSensorAxes() finds it.
Result<Isometry3d> PlainSamples::poseOf(const LiveSample& plain) const {
  const bool aboutBase = meta_.conventions.wrenchPoint.kind == Conventions::WrenchPoint::Kind::base;
  Isometry3d X_BS = Isometry3d::Identity();
  if (plain.orientation && (plain.position || !aboutBase)) {
    X_BS.linear() = plain.orientation->toRotationMatrix();
    if (plain.position) X_BS.translation() = *plain.position;
    return X_BS;
  }
  if (plain.q && robot_ && plain.joints == robot_->dof())
    return Isometry3d(robot_->linkPose(Eigen::Map<const VectorXd>(plain.q->data(), plain.joints), link_) *
                      poseFromXyzRpy(meta_.mount.xyz, meta_.mount.rpy));
  return Error{
      heft::say("The wrench is stated in the base's axes or about its origin, and the samples do not tell where "
                "the sensor is.") +
      " " + remedy(Remedy::nameRobot)};
}

Result<LiveSample> PlainSamples::plain(const LiveSample& read) const {
  LiveSample out = read;
  for (auto* angles : {&out.q, &out.dq}) {
    if (!*angles) continue;
    form_.undoAngles(Eigen::Map<MatrixXd>((*angles)->data(), 1, static_cast<Eigen::Index>((*angles)->size())));
  }
  MatrixXd quaternion;
  if (read.orientation) {
    quaternion = read.orientation->normalized().coeffs().transpose();
    form_.undoQuaternionOrder(quaternion);
    form_.undoDirection(quaternion);
    out.orientation = Quaterniond(quaternion(3), quaternion(0), quaternion(1), quaternion(2));
    if (read.position) {
      MatrixXd position = read.position->transpose();
      form_.undoPosition(position, quaternion);
      out.position = position.row(0).transpose();
    }
  }
  const auto undone = [](std::optional<Vector3d>& value, const auto& undo) {
    if (!value) return;
    MatrixXd row = value->transpose();
    undo(row);
    value = row.row(0).transpose();
  };
  undone(out.accelerometer, [&](MatrixXd& row) { form_.undoAcceleration(row); });
  undone(out.gyroscope, [&](MatrixXd& row) { form_.undoAngles(row); });
  if (!read.wrench) return out;
  MatrixXd wrench = read.wrench->transpose();
  form_.undoWrench(wrench);
  out.wrench = wrench.row(0).transpose();
  if (!meta_.conventions.needPose() || !out.hasMotion()) return out;
  const auto X_BS = poseOf(out);
  if (!X_BS) return X_BS.error();
  out.wrench = form_.inSensorAxes(*out.wrench, *X_BS);
  return out;
}

}  // namespace heft
