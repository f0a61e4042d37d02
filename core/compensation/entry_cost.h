#pragma once
// What it costs that a controller works with another payload than the estimated one: it takes the difference for a
// touch. Along a motion this phantom force uses up the collision threshold, and a compliant arm yields to it.
#include <algorithm>
#include <vector>

#include "core/base/result.h"
#include "core/estimation/estimate.h"

namespace heft {

/// What a controller reacts to.
struct ControllerLimits {
  double collisionForce = 0.0;   ///< Outside force that stops it [N], above zero
  double collisionTorque = 0.0;  ///< Likewise about F's origin [N m]
  double stiffness = 0.0;        ///< Of its Cartesian impedance [N/m]
};

struct EntryCost {
  Payload told;    ///< F axes; parts that nobody told are the estimate's
  Payload actual;  ///< F axes: the estimate with what else is mounted
  bool centreTold = false, inertiaTold = false;
  Isometry3d X_FS = Isometry3d::Identity();
  VectorXd time;  ///< Of the K instants [s]; pose numbers where the recording is of standing poses
  /// What the controller takes for a touch of the tool: force [N], torque about F's origin [N m], F axes.
  Eigen::Matrix<double, 6, Eigen::Dynamic> phantom;
  double force = 0, torque = 0;            ///< Their sizes stay below this for 99 % of the motion.
  double forceStd = 0, torqueStd = 0;      ///< Standard deviations of these two, from the estimate's.
  double weight = 0;                       ///< Standing still: more weight than told [N]; negative: less
  double forceShare = 0, torqueShare = 0;  ///< Of the collision thresholds, 1: all of it
  double sag = 0;                          ///< Of a compliant arm standing still [m]; negative: it rises
  bool differs = false;                    ///< By more than the estimate's own intervals allow
  Findings findings;                       ///< What was assumed about the sensor's mount

  double share() const { return std::max(forceShare, torqueShare); }
};

/// `told`: everything beyond the flange, F axes; needs a mass, zero is allowed. `mounted`: parts that the sensor does
/// not feel, F axes. Fails where the recording's motion cannot be read, the estimate has no trust, or the sensor's
/// place on the flange is not known. `robot` may be null where the recording carries poses.
Result<EntryCost> costOfEntry(const PartialPayload& told, const EstimateReport& report,
                              const std::vector<Payload>& mounted, const ControllerLimits& limits,
                              const Recording& recording, const RobotModel* robot);

}  // namespace heft
