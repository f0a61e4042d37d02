#include "core/motion/sensor_axes.h"

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/motion/motion.h"
#include "core/motion/mount_link.h"
#include "core/recording/plain_form.h"

namespace heft {

Result<bool> toSensorAxes(Recording& recording, const RobotModel* robot) {
  if (!recording.wrenchNeedsPose) return true;
  const PlainForm plain(recording.meta);
  const bool aboutBase = recording.meta.conventions.wrenchPoint.kind == Conventions::WrenchPoint::Kind::base;
  const bool poses = recording.hasOrientation() && (recording.hasPosition() || !aboutBase);
  int link = 0;
  if (!poses) {
    if (!recording.hasJoints())
      return errorAt({recording.file, 0, 0},
                     heft::say("the torque is about the base's origin, but where the sensor was is not recorded."),
                     heft::say("Record px, py, pz or the joint angles."));
    if (robot == nullptr || recording.q.cols() != robot->dof())
      return errorAt({recording.file, 0, 0},
                     robot == nullptr ? heft::say("the wrench is stated in the base's axes or about its origin, and "
                                                  "there is no robot to show where the sensor was.")
                                      : heft::say("there are {} joints, the robot \"{}\" has {}.", recording.q.cols(),
                                                  robot->name(), robot->dof()),
                     remedy(Remedy::nameRobot));
    const auto found = mountLink(recording.meta.mount, *robot);
    if (!found) return found.error();
    link = *found;
  }
  const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    Isometry3d X_BS = Isometry3d::Identity();
    if (poses) {
      const auto q = recording.quaternion.row(k);
      X_BS.linear() = Quaterniond(q(3), q(0), q(1), q(2)).normalized().toRotationMatrix();
      if (recording.hasPosition()) X_BS.translation() = recording.position.row(k).transpose();
    } else {
      X_BS = robot->linkPose(recording.q.row(k).transpose(), link) * X_LS;
    }
    recording.wrench.row(k) = plain.inSensorAxes(recording.wrench.row(k).transpose(), X_BS).transpose();
  }
  recording.wrenchNeedsPose = false;
  return true;
}

Result<bool> toSensorAxes(Recording& recording) {
  const bool poses = recording.hasOrientation() && recording.hasPosition();
  if (!recording.wrenchNeedsPose || poses || !recording.meta.robot) return toSensorAxes(recording, nullptr);
  Findings aside;
  const auto robot = robotFor(recording.meta, aside);
  if (!robot) return robot.error();
  return toSensorAxes(recording, &*robot);
}

}  // namespace heft
