#pragma once
// Joint motions given by formulas, so that their velocities and accelerations are exact.
#include <memory>
#include <vector>

#include "core/robot/robot_model.h"
#include "core/simulation/simulate.h"

namespace heft {

/// A value with its first and second time derivative.
struct Jet {
  double value = 0.0, rate = 0.0, second = 0.0;
};

/// 0 before u = 0, 1 after u = 1, between them u^3 (10 - 15 u + 6 u^2): the minimum-jerk profile (Flash and Hogan
/// 1985).
Jet minimumJerk(double u);

/// Room that a joint has, with defaults where the robot states no limit and a margin taken off.
struct JointRoom {
  double lower = 0.0, upper = 0.0;  ///< [rad]
  double velocity = 0.0;            ///< [rad/s]
  double acceleration = 0.0;        ///< [rad/s2]
  double unit = 1.0;                ///< Size of one "radian" of motion: 1 for a hinge, 0.3 m for a slider.
};
std::vector<JointRoom> jointRooms(const RobotModel& robot, const VectorXd& home);

/// The frame whose Cartesian motion is limited: S on its link.
struct ToolFrame {
  int link = 0;
  Isometry3d X_LS = Isometry3d::Identity();
};

/// Largest of speed, turning rate, linear and angular acceleration of the link and of S, each over its limit.
double cartesianLoad(const RobotModel& robot, const ToolFrame& tool, const VectorXd& q, const VectorXd& dq,
                     const VectorXd& ddq);

struct Wave {
  double omega = 0.0, phase = 0.0, amplitude = 0.0;
};

/// amplitude * sin(omega t + phase) added to a jet.
void addWave(const Wave& wave, double t, Jet& jet);

/// Physiological tremor of the guiding hand, 8 to 11 Hz, 0.2 to 0.5 mrad; fades in and out with the grip.
class Tremor {
 public:
  Tremor() = default;
  Tremor(std::uint64_t seed, const std::vector<JointRoom>& rooms, double from, double to, double fade);
  void add(double t, VectorXd& q, VectorXd& dq, VectorXd& ddq) const;
  /// Bounds of what it adds to joint j.
  Jet bound(std::size_t j) const;

 private:
  std::vector<std::vector<Wave>> waves_;
  double from_ = 0.0, to_ = 0.0, fade_ = 1.0;
};

/// One touch: while it lasts the sensor balances `level(t) * force` through a point fixed in S.
struct Contact {
  double from = 0.0, to = 0.0;        ///< [s]
  double edge = 0.0;                  ///< rise and fall [s]; 0: one half sine
  Vector3d force = Vector3d::Zero();  ///< peak of what the sensor exerts on the payload, B axes [N]
  Vector3d point = Vector3d::Zero();  ///< p_SoC_S [m]
  double level(double t) const;       ///< 0 outside, up to 1 inside
};

class Trajectory {
 public:
  virtual ~Trajectory() = default;
  /// q, dq, ddq at t in [0, duration]; all have dof() entries.
  virtual void at(double t, VectorXd& q, VectorXd& dq, VectorXd& ddq) const = 0;
  virtual std::vector<Contact> contacts() const { return {}; }
};

/// `options` have been checked. Never fails: what the limits forbid is scaled down.
std::unique_ptr<Trajectory> planTrajectory(const RobotModel& robot, const ToolFrame& tool, const Payload& payload,
                                           const SimulateOptions& options);
std::unique_ptr<Trajectory> planWander(const RobotModel& robot, const ToolFrame& tool, const SimulateOptions& options);
std::unique_ptr<Trajectory> planPickAndPlace(const RobotModel& robot, const ToolFrame& tool, const Payload& payload,
                                             const SimulateOptions& options);

}  // namespace heft
