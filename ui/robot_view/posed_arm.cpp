#include "ui/robot_view/posed_arm.h"

#include <algorithm>
#include <cmath>

namespace heft {
namespace {

constexpr int kInstants = 200;       ///< Over the recording
constexpr int kIterations = 100;     ///< At most, for one instant
constexpr double kDamping = 0.05;    ///< Of the inverse [m], [rad]
constexpr double kReached = 1e-3;    ///< [m], [rad] More is not drawn: 1 mm and 0.06 degrees
constexpr double kHomewards = 0.05;  ///< Share of the way home that the free elbow takes in an iteration
constexpr double kFastest = 3.0;     ///< [rad] between neighbouring instants: more is a leap, not a motion
constexpr const char* kFlange = "panda_link8";

/// Brings `link` to X_BL with the joints nearest to `q`; false where it does not get there within the limits.
bool solve(const RobotModel& robot, int link, const Isometry3d& X_BL, VectorXd& q) {
  const VectorXd home = robot.homePosture();
  for (int k = 0; k < kIterations; ++k) {
    const Isometry3d now = robot.linkPose(q, link);
    Vector6d error;
    error.head<3>() = X_BL.translation() - now.translation();
    const Eigen::AngleAxisd turn(Matrix3d(X_BL.linear() * now.linear().transpose()));
    error.tail<3>() = turn.angle() * turn.axis();
    if (error.head<3>().norm() < kReached && error.tail<3>().norm() < kReached) return true;
    const Eigen::Matrix<double, 6, Eigen::Dynamic> J = robot.jacobian(link, Isometry3d::Identity(), q);
    // Damped more where the way is long, so that the last steps are exact.
    const double damping = kDamping * std::min(1.0, error.norm());
    const Matrix6d inverse = (J * J.transpose() + damping * damping * Matrix6d::Identity()).inverse();
    const VectorXd towards = kHomewards * (home - q);
    const VectorXd step = towards + J.transpose() * (inverse * (error - J * towards));
    q = robot.clampToLimits(q + step * std::min(1.0, 0.5 / std::max(1e-9, step.cwiseAbs().maxCoeff())));
  }
  return false;
}

}  // namespace

std::optional<PosedArm> PosedArm::follow(const SceneTrack& track, const SensorMount& mount, double first, double last,
                                         std::shared_ptr<const RobotModel> robot) {
  const auto flange = robot ? robot->findLink(kFlange) : std::nullopt;
  if (!flange || !track.positionKnown() || !(last >= first)) return std::nullopt;
  const Isometry3d X_SF = poseFromXyzRpy(mount.xyz, mount.rpy).inverse();
  PosedArm out;
  out.robot_ = std::move(robot);
  out.first_ = first;
  out.step_ = std::max(1e-9, (last - first) / (kInstants - 1));
  VectorXd q = out.robot_->homePosture();
  for (int k = 0; k < kInstants; ++k) {
    const VectorXd before = q;
    if (!solve(*out.robot_, *flange, track.sensorAt(first + k * out.step_) * X_SF, q)) return std::nullopt;
    if (k > 0 && (q - before).cwiseAbs().maxCoeff() > kFastest) return std::nullopt;
    out.joints_.push_back(q);
  }
  return out;
}

VectorXd PosedArm::jointsAt(double time) const {
  const double at = std::clamp((time - first_) / step_, 0.0, static_cast<double>(joints_.size() - 1));
  const auto before = std::min(static_cast<std::size_t>(at), joints_.size() - 2);
  const double share = at - static_cast<double>(before);
  return (1.0 - share) * joints_[before] + share * joints_[before + 1];
}

}  // namespace heft
