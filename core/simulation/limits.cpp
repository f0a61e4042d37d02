// What the joints and the flange may do.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/trajectory.h"

namespace heft {

namespace {

// Panda's Cartesian limits (manufacturer's interface specification); a sane cap for other arms that carry a hand-guided
// tool. The share kept free covers what lies between the instants at which a plan is checked.
constexpr double kShare = 0.93;
constexpr double kSpeed = 1.7 * kShare;                 // [m/s]
constexpr double kTurningRate = 2.5 * kShare;           // [rad/s]
constexpr double kAcceleration = 13.0 * kShare;         // [m/s2]
constexpr double kAngularAcceleration = 25.0 * kShare;  // [rad/s2]

double orDefault(double limit, double fallback) { return std::isfinite(limit) ? std::max(0.0, limit) : fallback; }

}  // namespace

std::vector<JointRoom> jointRooms(const RobotModel& robot, const VectorXd& home) {
  std::vector<JointRoom> rooms;
  for (int j = 0; j < robot.dof(); ++j) {
    const JointLimits& limits = robot.limits(j);
    const bool slider = robot.joints()[robot.movingJoints()[j]].type == JointType::prismatic;
    JointRoom room;
    room.unit = slider ? 0.3 : 1.0;
    room.velocity = 0.95 * orDefault(limits.velocity, slider ? 0.5 : 2.0);
    room.acceleration = 0.95 * orDefault(limits.acceleration, slider ? 3.0 : 10.0);
    const double half = slider ? 0.5 : std::numbers::pi;
    room.lower = std::isfinite(limits.lower) ? limits.lower : home(j) - half;
    room.upper = std::isfinite(limits.upper) ? limits.upper : home(j) + half;
    if (room.upper < room.lower) room.lower = room.upper = home(j);
    const double margin = std::min(0.03 * room.unit, 0.05 * (room.upper - room.lower));
    room.lower += margin;
    room.upper -= margin;
    rooms.push_back(room);
  }
  return rooms;
}

double cartesianLoad(const RobotModel& robot, const ToolFrame& tool, const VectorXd& q, const VectorXd& dq,
                     const VectorXd& ddq) {
  const FrameMotion motion = robot.frameMotion(tool.link, tool.X_LS, q, dq, ddq);
  const Vector3d& w = motion.w_BS_B;
  const Vector3d& alpha = motion.alpha_BS_B;
  const Vector3d p_SoLo_B = motion.X_BS.linear() * (tool.X_LS.linear().transpose() * -tool.X_LS.translation());
  const Vector3d linkVelocity = motion.v_BSo_B + w.cross(p_SoLo_B);
  const Vector3d linkAcceleration = motion.a_BSo_B + alpha.cross(p_SoLo_B) + w.cross(w.cross(p_SoLo_B));
  return std::max({motion.v_BSo_B.norm() / kSpeed, linkVelocity.norm() / kSpeed, w.norm() / kTurningRate,
                   motion.a_BSo_B.norm() / kAcceleration, linkAcceleration.norm() / kAcceleration,
                   alpha.norm() / kAngularAcceleration});
}

}  // namespace heft
