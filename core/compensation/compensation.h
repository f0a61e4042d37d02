#pragma once
// What is left of the measured wrench without the payload's share: the contact forces of a demonstration, and its
// phases, as input for hybrid motion-force programs.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/estimation/options.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

using WrenchSamples = Eigen::Matrix<double, Eigen::Dynamic, 6>;

enum class Phase {
  free,      ///< Touches nothing.
  approach,  ///< Touches nothing yet; moves towards the contact that follows.
  contact,
  ignore,  ///< Not to be used: sensor trouble, another payload, or the user said so.
};
std::string_view toString(Phase phase);

struct PhaseSegment {
  double from = 0, to = 0;  ///< [s]
  Phase phase = Phase::free;
  std::string reason;
  double confidence = 1.0;  ///< 0..1
  /// Contact: what the surroundings exert on the tool, S axes, about S's origin.
  Vector3d meanForce = Vector3d::Zero(), meanTorque = Vector3d::Zero();  ///< [N], [N m]
  double peakForce = 0.0;                                                ///< [N]
  /// Approach, with a known position: unit direction of travel in B axes, length and mean speed; zero otherwise.
  Vector3d direction_B = Vector3d::Zero();
  double distance = 0.0, speed = 0.0;  ///< [m], [m/s]
};

struct CompensateOptions {
  EstimateOptions estimate;          ///< How the motion is smoothed and the recording segmented.
  PayloadGuess payload;              ///< What is taken off.
  Vector6d bias = Vector6d::Zero();  ///< Of the result [N], [N m]: used where the recording has too little free motion.
};

struct Compensated {
  VectorXd time;             ///< The recording's rows [s]
  WrenchSamples wrench;      ///< F_PSo_S less the payload's share and bias [N], [N m]; the sensor's sign, S axes
  std::vector<Phase> phase;  ///< One a row.
  std::vector<PhaseSegment> segments;
  Vector6d bias = Vector6d::Zero();            ///< That was taken off.
  bool ownBias = false;                        ///< It comes from this recording's free parts.
  double freeForceRms = 0, freeTorqueRms = 0;  ///< What is left in free motion [N], [N m]
  double noiseForce = 0,
         noiseTorque = 0;  ///< The sensor's own scatter, from steps between rows of `wrench` that differ
  Findings findings;
};

/// The bias is that of the recording's own free parts where they last a second at least: biases wander between
/// recordings. `robot` may be null where the recording carries poses. Fails for standing poses.
Result<Compensated> compensate(const Recording& recording, const RobotModel* robot, const CompensateOptions& options,
                               const Progress& progress = {});

/// Payload and bias of a result file (or of a bare payload, without a bias).
Result<CompensateOptions> compensateOptionsFromJson(const nlohmann::json& result, const std::string& where);

/// heft.compensate/1, without the findings.
nlohmann::json toJson(const Compensated& compensated, const Recording& recording);
/// time, joints and pose as recorded, fx..tz compensated, phase; a row a sample.
std::string toCsv(const Compensated& compensated, const Recording& recording);
std::string toText(const Compensated& compensated, const Recording& recording);

}  // namespace heft
