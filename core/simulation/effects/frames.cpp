// Mistakes with frames and signs, as people make them.
#include <cmath>
#include <numbers>

#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

/// Replaces the joints by the sensor's pose, as a log of the tool frame has it.
void logPoses(Recording& recording, const RobotModel& robot) {
  const auto link = robot.findLink(recording.meta.mount.parent);
  if (!recording.hasJoints() || !link) return;
  const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  recording.position.resize(recording.rows(), 3);
  recording.quaternion.resize(recording.rows(), 4);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    const Isometry3d X_BS = robot.linkPose(recording.q.row(k).transpose(), *link) * X_LS;
    recording.position.row(k) = X_BS.translation();
    recording.quaternion.row(k) = Quaterniond(X_BS.linear()).coeffs();
    if (k > 0 && recording.quaternion.row(k).dot(recording.quaternion.row(k - 1)) < 0.0)
      recording.quaternion.row(k) *= -1.0;
  }
  recording.q.resize(0, 0);
  recording.dq.resize(0, 0);
}

class FrameError final : public Effect {
 public:
  explicit FrameError(const EffectSetup& setup) : form_(setup.form), robot_(setup.scene.robot) {
    const Vector3d axis = form_ == "upside-down" ? Vector3d::UnitX() : Vector3d::UnitZ();
    double degrees = 0.0;
    if (form_ == "mount-180" || form_ == "upside-down") degrees = 180.0;
    if (form_ == "mount-90") degrees = setup.random.chance(0.5) ? 90.0 : -90.0;
    if (form_ == "mount-45") degrees = setup.random.chance(0.5) ? 45.0 : -45.0;
    R_ = rotationFromVector(degrees * std::numbers::pi / 180.0 * axis);
    if (degrees != 0.0) {
      note("axis_s", axis);
      note("angle_rad", degrees * std::numbers::pi / 180.0);
    }
  }
  Vector6d gauge(const Vector6d& load) override {
    Vector6d out;
    out << R_.transpose() * load.head<3>(), R_.transpose() * load.tail<3>();
    return out;
  }
  void log(Recording& recording) override {
    if (form_ == "wrench-sign") recording.wrench *= -1.0;
    if (form_ == "gravity-sign") recording.meta.gravity *= -1.0;
    if (form_ == "swapped-xy") {
      recording.wrench.col(0).swap(recording.wrench.col(1));
      recording.wrench.col(3).swap(recording.wrench.col(4));
    }
    if (form_ == "transposed") {
      if (robot_ != nullptr) logPoses(recording, *robot_);
      if (recording.hasOrientation()) recording.quaternion.leftCols<3>() *= -1.0;
    }
    if (form_ == "w-first") {
      if (robot_ != nullptr) logPoses(recording, *robot_);
      for (Eigen::Index i = 0; recording.hasOrientation() && i < recording.rows(); ++i) {
        const Eigen::RowVector4d q = recording.quaternion.row(i);
        recording.quaternion.row(i) << q(3), q(0), q(1), q(2);
      }
    }
  }

 private:
  std::string form_;
  const RobotModel* robot_;
  Matrix3d R_ = Matrix3d::Identity();
};

}  // namespace

void addFrameKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"frame_error",
                   "(1 is present)",
                   "a mistake with frames or signs",
                   1.0,
                   1.0,
                   false,
                   {"mount-180", "upside-down", "mount-90", "mount-45", "transposed", "w-first", "gravity-sign",
                    "wrench-sign", "swapped-xy"},
                   making<FrameError>()});
}

}  // namespace heft
