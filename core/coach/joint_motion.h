#pragma once
// Joint trajectories that are proposed to a person or a robot, and the limits that they keep.
#include <string>
#include <vector>

#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

/// A smooth joint motion, sampled; between the samples quintic polynomials that meet in position, velocity and
/// acceleration.
struct JointMotion {
  VectorXd time;        ///< [s], rising, from 0
  MatrixXd q, dq, ddq;  ///< N x dof [rad], [rad/s], [rad/s2]
  Eigen::Index size() const { return time.size(); }
  double duration() const { return size() > 0 ? time(size() - 1) : 0.0; }
  void at(double t, VectorXd& position, VectorXd& velocity, VectorXd& acceleration) const;
  /// The same motion with `factor` times the duration.
  JointMotion slower(double factor) const;
};

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
};

/// Largest use of each limit over a motion, 1 = at the limit. The joints' own limits with the same margins as the
/// simulation, defaults where the robot states none.
struct LimitUse {
  double position = 0.0, velocity = 0.0, acceleration = 0.0, tcpSpeed = 0.0;
  double cartesian = 0.0;        ///< Turning rate and accelerations of the flange (core/simulation)
  double largestTcpSpeed = 0.0;  ///< [m/s]
  double largest() const;
  bool kept() const { return largest() <= 1.0; }
  std::string worst() const;  ///< "the speed of the tool", the limit that is used most
};
LimitUse limitUse(const GuidedTool& tool, const JointMotion& motion, const MotionLimits& limits);

/// time, q1.., dq1.., at `rateHz`, in the columns of a recording.
std::string trajectoryCsv(const JointMotion& motion, double rateHz);

}  // namespace heft
