#include "core/coach/joint_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/mount_link.h"
#include "core/simulation/trajectory.h"

namespace heft {

void JointMotion::at(double t, VectorXd& position, VectorXd& velocity, VectorXd& acceleration) const {
  const double* begin = time.data();
  const auto next = std::clamp<Eigen::Index>(std::upper_bound(begin, begin + size(), t) - begin, 1, size() - 1);
  const Eigen::Index k = next - 1;
  const double h = time(next) - time(k);
  const double u = std::clamp((t - time(k)) / h, 0.0, 1.0);
  const double u2 = u * u, u3 = u2 * u, u4 = u3 * u, u5 = u4 * u;
  // Quintic Hermite basis and its derivatives in u.
  const double b[6] = {1 - 10 * u3 + 15 * u4 - 6 * u5, u - 6 * u3 + 8 * u4 - 3 * u5, 0.5 * (u2 - 3 * u3 + 3 * u4 - u5),
                       0.5 * (u3 - 2 * u4 + u5),       -4 * u3 + 7 * u4 - 3 * u5,    10 * u3 - 15 * u4 + 6 * u5};
  const double d[6] = {
      -30 * u2 + 60 * u3 - 30 * u4,     1 - 18 * u2 + 32 * u3 - 15 * u4, 0.5 * (2 * u - 9 * u2 + 12 * u3 - 5 * u4),
      0.5 * (3 * u2 - 8 * u3 + 5 * u4), -12 * u2 + 28 * u3 - 15 * u4,    30 * u2 - 60 * u3 + 30 * u4};
  const double s[6] = {
      -60 * u + 180 * u2 - 120 * u3,     -36 * u + 96 * u2 - 60 * u3, 0.5 * (2 - 18 * u + 36 * u2 - 20 * u3),
      0.5 * (6 * u - 24 * u2 + 20 * u3), -24 * u + 84 * u2 - 60 * u3, 60 * u - 180 * u2 + 120 * u3};
  const auto mix = [&](const double* w) {
    return VectorXd((w[0] * q.row(k) + h * w[1] * dq.row(k) + h * h * w[2] * ddq.row(k) + h * h * w[3] * ddq.row(next) +
                     h * w[4] * dq.row(next) + w[5] * q.row(next))
                        .transpose());
  };
  position = mix(b);
  velocity = mix(d) / h;
  acceleration = mix(s) / (h * h);
}

JointMotion JointMotion::slower(double factor) const {
  return {time * factor, q, dq / factor, ddq / (factor * factor)};
}

Result<GuidedTool> guidedTool(const RobotModel& robot, const SensorMount& mount) {
  const auto link = mountLink(mount, robot);
  if (!link) return link.error();
  return GuidedTool{&robot, *link, poseFromXyzRpy(mount.xyz, mount.rpy), {}};
}

double LimitUse::largest() const { return std::max({position, velocity, acceleration, tcpSpeed, cartesian}); }

std::string LimitUse::worst() const {
  const double most = largest();
  if (most == position) return "a joint's range";
  if (most == velocity) return "a joint's speed";
  if (most == acceleration) return "a joint's acceleration";
  if (most == tcpSpeed) return "the speed of the tool";
  return "the turning rate or acceleration of the flange";
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
  return use;
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
