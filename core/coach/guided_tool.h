#pragma once
// The tool on the arm, and the limits that motions proposed to a person or a robot keep.
#include <optional>
#include <string>
#include <vector>

#include "core/collision/clearance.h"
#include "core/payload/inertial_parameters.h"
#include "core/recording/recording.h"
#include "core/robot/joint_motion.h"
#include "core/robot/robot_model.h"

namespace heft {

/// The sensor frame on the arm and the points of the tool whose speed counts.
struct GuidedTool {
  const RobotModel* robot = nullptr;  ///< Not null, outlives this.
  int link = 0;
  Isometry3d X_LS = Isometry3d::Identity();
  std::vector<Vector3d> points;  ///< p_SQ_S [m]; S's origin always counts
};

/// Fails if the mount's link is not there.
Result<GuidedTool> guidedTool(const RobotModel& robot, const SensorMount& mount);

/// Speed of the tool centre point beside people: 250 mm/s, the usual cap where a person is within reach (ISO 10218-1
/// for guided operation; ISO/TS 15066 sets what contact may transfer).
constexpr double kTcpSpeed = 0.25;

struct MotionLimits {
  double tcpSpeed = kTcpSpeed;  ///< [m/s]
  const Clearance* clearance =
      nullptr;                        ///< Nothing may come nearer than its margin; null: nobody looks. Outlives this.
  Vector3d gravity{0.0, 0.0, -9.81};  ///< g_B [m/s2], for the joints' torques
  std::optional<Payload> payload;     ///< What is known so far of what the arm carries, for the same
};

/// The moment of a motion that takes most of a joint's torque.
struct TorqueUse {
  double share = 0.0;            ///< Of what the joint may give; 0 where the robot does not state what torques need
  std::string joint;             ///< Empty: not known
  double needed = 0.0;           ///< [N m] or [N]
  double allowed = 0.0;          ///< The robot's limit, less a tenth for friction
  double time = 0.0;             ///< [s]
  std::string sentence() const;  ///< "Joint elbow would need 95.0 of the 78.3 N m that it may give, 1.2 s into it."
};
/// Of arm and payload, at the samples of `motion`.
TorqueUse torqueUse(const GuidedTool& tool, const JointMotion& motion, const MotionLimits& limits);

/// Largest use of each limit over a motion, 1 = at the limit. The joints' own limits with the same margins as the
/// simulation, defaults where the robot states none.
struct LimitUse {
  double position = 0.0, velocity = 0.0, acceleration = 0.0, tcpSpeed = 0.0;
  double cartesian = 0.0;        ///< Turning rate and accelerations of the flange (core/simulation)
  double largestTcpSpeed = 0.0;  ///< [m/s]
  TorqueUse torque;
  double largest() const;
  bool kept() const { return largest() <= 1.0; }
  std::string worst() const;  ///< "the speed of the tool", the limit that is used most
};
LimitUse limitUse(const GuidedTool& tool, const JointMotion& motion, const MotionLimits& limits);

/// Whether the arm can go straight from the one posture to the other, clear of everything, and hold what it carries
/// there. Where nobody looks it is clear of everything.
bool isReached(const GuidedTool& tool, const VectorXd& from, const VectorXd& to, const MotionLimits& limits);

/// time, q1.., dq1.., at `rateHz`, in the columns of a recording.
std::string trajectoryCsv(const JointMotion& motion, double rateHz);

}  // namespace heft
