#include "core/coach/guided_tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/motion/mount_link.h"
#include "core/robot/joint_torques.h"
#include "core/simulation/trajectory.h"

namespace heft {

Result<GuidedTool> guidedTool(const RobotModel& robot, const SensorMount& mount) {
  const auto link = mountLink(mount, robot);
  if (!link) return link.error();
  return GuidedTool{&robot, *link, poseFromXyzRpy(mount.xyz, mount.rpy), {}};
}

double LimitUse::largest() const {
  return std::max({position, velocity, acceleration, tcpSpeed, cartesian, torque.share});
}

std::string LimitUse::worst() const {
  const double most = largest();
  if (most == position) return "a joint's range";
  if (most == velocity) return "a joint's speed";
  if (most == acceleration) return "a joint's acceleration";
  if (most == tcpSpeed) return "the speed of the tool";
  if (most == torque.share) return "the torque of " + torque.joint;
  return "the turning rate or acceleration of the flange";
}

std::string TorqueUse::sentence() const {
  return heft::say("Joint {} would need {:.1f} N m of the allowed {:.1f} N m, {:.1f} s into the motion.", joint, needed,
                   allowed, time);
}

TorqueUse torqueUse(const GuidedTool& tool, const JointMotion& motion, const MotionLimits& limits) {
  // Friction, which no URDF tells well, takes up to 0.84 N m of a Panda joint's 12 (Gaz et al. 2019).
  constexpr double kWithoutFriction = 0.9;
  const RobotModel& robot = *tool.robot;
  TorqueUse out;
  if (!statesTorques(robot)) return out;
  std::optional<CarriedBody> carried;
  if (limits.payload && limits.payload->mass > 0.0) {
    const Matrix3d R = tool.X_LS.linear();
    carried = CarriedBody{
        tool.link,
        {limits.payload->mass, tool.X_LS * limits.payload->com, R * limits.payload->inertiaCom * R.transpose()}};
  }
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    const VectorXd torques = jointTorques(robot, limits.gravity, carried, motion.q.row(k).transpose(),
                                          motion.dq.row(k).transpose(), motion.ddq.row(k).transpose());
    for (int j = 0; j < robot.dof(); ++j) {
      const double allowed = kWithoutFriction * robot.limits(j).effort, needed = std::abs(torques(j));
      if (needed / allowed <= out.share) continue;
      const auto joint = static_cast<std::size_t>(robot.movingJoints()[static_cast<std::size_t>(j)]);
      out = {needed / allowed, robot.joints()[joint].name, needed, allowed, motion.time(k)};
    }
  }
  return out;
}

LimitUse limitUse(const GuidedTool& tool, const JointMotion& motion, const MotionLimits& limits) {
  const RobotModel& robot = *tool.robot;
  const auto rooms = jointRooms(robot, robot.homePosture());
  const ToolFrame frame{tool.link, tool.X_LS};
  LimitUse use;
  // Between the samples too, where the polynomials may bulge.
  constexpr int kBetween = 3;
  VectorXd q, dq, ddq;
  for (Eigen::Index k = 0; k + 1 < motion.size(); ++k)
    for (int i = 0; i < kBetween; ++i) {
      motion.at(motion.time(k) + (motion.time(k + 1) - motion.time(k)) * i / kBetween, q, dq, ddq);
      for (int j = 0; j < robot.dof(); ++j) {
        const JointRoom& room = rooms[static_cast<std::size_t>(j)];
        const double half = std::max(1e-9, 0.5 * (room.upper - room.lower));
        use.position = std::max(use.position, std::abs(q(j) - 0.5 * (room.upper + room.lower)) / half);
        use.velocity = std::max(use.velocity, std::abs(dq(j)) / std::max(1e-9, room.velocity));
        use.acceleration = std::max(use.acceleration, std::abs(ddq(j)) / std::max(1e-9, room.acceleration));
      }
      use.cartesian = std::max(use.cartesian, cartesianLoad(robot, frame, q, dq, ddq));
      const FrameMotion m = robot.frameMotion(tool.link, tool.X_LS, q, dq, ddq);
      double speed = m.v_BSo_B.norm();
      for (const Vector3d& p : tool.points)
        speed = std::max(speed, (m.v_BSo_B + m.w_BS_B.cross(m.X_BS.linear() * p)).norm());
      use.largestTcpSpeed = std::max(use.largestTcpSpeed, speed);
    }
  use.tcpSpeed = use.largestTcpSpeed / limits.tcpSpeed;
  use.torque = torqueUse(tool, motion, limits);
  return use;
}

bool isReached(const GuidedTool& tool, const VectorXd& from, const VectorXd& to, const MotionLimits& limits) {
  constexpr double kSeconds = 1.0;  // How long it takes changes nothing
  const MatrixXd rest = MatrixXd::Zero(1, to.size());
  const JointMotion there{VectorXd::Zero(1), to.transpose(), rest, rest};
  return torqueUse(tool, there, limits).share <= 1.0 &&
         (limits.clearance == nullptr || !limits.clearance->firstConflict(straightMotion(from, to, kSeconds)));
}

std::string trajectoryCsv(const JointMotion& motion, double rateHz) {
  const Eigen::Index dof = motion.q.cols();
  std::string text = "time";
  for (const char* name : {"q", "dq"})
    for (Eigen::Index j = 1; j <= dof; ++j) text += fmt::format(",{}{}", name, j);
  text += "\n";
  const auto rows = static_cast<Eigen::Index>(std::floor(motion.duration() * rateHz + 1e-6)) + 1;
  VectorXd q, dq, ddq;
  for (Eigen::Index k = 0; k < rows; ++k) {
    const double t = static_cast<double>(k) / rateHz;
    motion.at(t, q, dq, ddq);
    text += fmt::format("{:.6f}", t);
    for (Eigen::Index j = 0; j < dof; ++j) text += fmt::format(",{:.9f}", q(j));
    for (Eigen::Index j = 0; j < dof; ++j) text += fmt::format(",{:.9f}", dq(j));
    text += "\n";
  }
  return text;
}

}  // namespace heft
