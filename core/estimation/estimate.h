#pragma once
// From a recording to a payload with intervals: the whole pipeline, and its result.
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/conventions/check.h"
#include "core/estimation/evidence.h"
#include "core/estimation/identifiability.h"
#include "core/estimation/options.h"
#include "core/payload/payload_interval.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"
#include "core/segmentation/segmentation.h"

namespace heft {

struct RelativeError {
  double mass = 0, com = 0, inertiaCom = 0, inertiaOrigin = 0;
  bool hasMass = false, hasCom = false, hasInertia = false;
};

/// Measured and simulated wrench on the recording's clock, for plots; K samples.
struct WrenchSeries {
  VectorXd time;                                       ///< [s]
  Eigen::Matrix<double, Eigen::Dynamic, 6> measured;   ///< As in Recording::wrench
  Eigen::Matrix<double, Eigen::Dynamic, 6> simulated;  ///< Payload's wrench plus bias
};

/// Whether the numbers may be relied on.
enum class Trust {
  good,
  low,   ///< They may be off by more than their intervals say; a finding says why.
  none,  ///< The model does not describe the readings: the numbers mean nothing, and no label is "data".
};
std::string_view toString(Trust trust);  ///< "good", "low", "none"

struct EstimateReport {
  Method method = Method::map;
  ParameterSet parameters = ParameterSet::full;
  std::string file;
  SensorMount mount;  ///< S in the robot's link, for writing the payload in the flange's frame.
  Eigen::Index samples = 0;
  double rateHz = 0, duration = 0, usedDuration = 0;
  Trust trust = Trust::good;
  std::string whyNoTrust, whatToDo;  ///< With Trust::none: what is wrong, and the next step. A sentence or two each.
  conventions::Report conventions;   ///< What physics says the numbers mean.
  bool readAsSuggested = false;      ///< The numbers were understood as it suggests.
  bool motionFromJoints = true;      ///< Else from poses.
  Payload payload;
  Payload std;  ///< Standard deviations in the same places.
  PayloadInterval interval95;
  Matrix10d correlation = Matrix10d::Identity();  ///< Of componentsOf(payload) about the estimate; 0 for what was held
  Vector3d forceBias = Vector3d::Zero(), torqueBias = Vector3d::Zero();
  bool physicallyConsistent = false;
  Identifiability identifiability;
  Evidence evidence;
  double forceRms = 0, torqueRms = 0, heldoutForceRms = 0, heldoutTorqueRms = 0;  ///< [N], [N m], over the used parts
  double unseenForceShare = 0, unseenTorqueShare = 0;  ///< Held-out error beyond noise over what the motion made
  bool forcesMisfit = false;             ///< Of a finding "misfit": it is about forces, too, not torques alone
  Vector6d noiseStd = Vector6d::Zero();  ///< The sensor's own scatter per channel, from one sample of `series` to the
                                         ///< next; what is slow in the residual is not in it [N], [N m]
  std::vector<Segment> segments;
  struct Timing {
    double read = 0, prepare = 0, solve = 0, total = 0;
  } timing;  ///< [s]
  struct Termination {
    bool usable = false;
    std::string why;  ///< Why the solver stopped, one sentence.
    int iterations = 0;
  } termination;
  std::optional<RelativeError> relativeError;
  std::optional<ConfiguredPayload> configured;  ///< As in Recording.
  WrenchSeries series;
  Findings findings;
};

/// Runs the pipeline on a recording already in memory. `robot` may be null where the recording carries poses.
Result<EstimateReport> estimate(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                                const Progress& progress = {});

/// The contract's heft.estimate/1.
nlohmann::json toJson(const EstimateReport& report);

/// For a person: plain words first, numbers with units and intervals second.
std::string toText(const EstimateReport& report);

}  // namespace heft
