#pragma once
// An arm that a hand guides: it follows a pull on its tool, smoothly and inside its limits, as a compliant arm does.
#include <functional>

#include "core/simulation/trajectory.h"

namespace heft {

/// A joint motion that begins and ends at rest.
struct GuidedPath {
  double duration = 0.0;  ///< [s]
  /// q, dq, ddq (dof() entries) at t in [0, duration].
  std::function<void(double t, VectorXd& q, VectorXd& dq, VectorXd& ddq)> at;
};

/// What guiding may reach. A hand is slower than the arm could be.
constexpr double kGuidedSpeed = 0.5;        ///< Of S's origin [m/s]
constexpr double kGuidedTurningRate = 1.8;  ///< [rad/s]

/// Joint position, velocity and acceleration are a triple integrator's: exactly consistent with one another. Position,
/// velocity and acceleration limits of the joints (jointRooms) and the Cartesian ones (cartesianLoad) hold at every
/// step. Not safe to use from several threads at once.
class GuidedArm {
 public:
  /// `robot` must outlive this. At rest in its home posture.
  GuidedArm(const RobotModel& robot, const ToolFrame& tool);

  const RobotModel& robot() const { return *robot_; }
  const ToolFrame& tool() const { return tool_; }
  const VectorXd& q() const { return q_; }      ///< [rad]
  const VectorXd& dq() const { return dq_; }    ///< [rad/s]
  const VectorXd& ddq() const { return ddq_; }  ///< [rad/s2]
  /// X_BS now.
  Isometry3d pose() const;

  /// The hand holds S and pulls it towards X_BS until it lets go. What cannot be reached is approached.
  void pullTo(const Isometry3d& X_BS);
  /// Where the hand pulls to, or the pose now if nobody pulls.
  Isometry3d pulledTo() const;
  /// The arm comes to rest where it is.
  void letGo();
  /// Goes on by itself, about where it is: smooth turns and shifts in all directions, without end.
  void wander();
  /// Goes to the path's beginning, waits until it rests there, and follows it.
  void follow(GuidedPath path);
  /// Goes to a posture.
  void goTo(const VectorXd& q);

  enum class Mode { resting, pulled, wandering, approaching, following };
  Mode mode() const { return mode_; }
  /// Nearly still, and nothing wants it to move.
  bool atRest() const;
  /// Share of the path that is done, 0 while approaching it.
  double followed() const;

  /// Goes on by `dt` [s], 0.1 ms to 5 ms.
  void step(double dt);

 private:
  VectorXd wantedVelocity();
  VectorXd velocityTowards(const Isometry3d& X_BS) const;
  Isometry3d wanderedTo() const;
  void limitVelocity(VectorXd& dq) const;
  void limitAcceleration(VectorXd& ddq) const;
  void brakeBeforeEnds(VectorXd& ddq) const;

  const RobotModel* robot_;
  ToolFrame tool_;
  std::vector<JointRoom> rooms_;
  VectorXd home_, q_, dq_, ddq_;
  Mode mode_ = Mode::resting;
  Isometry3d target_ = Isometry3d::Identity();  ///< Pulled to, or the middle of the wandering
  double clock_ = 0.0;                          ///< [s] Of wandering and following
  GuidedPath path_;
  VectorXd pathStart_, pathOffset_;
};

}  // namespace heft
