#pragma once
// Whether a payload, as it was entered somewhere, is what a recording carries: the measured wrench less the payload's
// share must be the sensor's noise, as far as the payload's own interval allows.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "core/estimation/estimate.h"

namespace heft {

enum class ProofVerdict {
  pass,        ///< Nothing but noise and the payload's own interval is left.
  notYet,      ///< Another payload, or something besides a rigid payload, is at work.
  cannotTell,  ///< The motion (or the payload's interval) would also let a wrong payload pass.
};
std::string_view toString(ProofVerdict verdict);  ///< "pass", "not_yet", "cannot_tell"

/// What is to be proved.
struct EnteredPayload {
  Payload payload;
  Payload std;                ///< Standard deviations in the same places; zero: taken as exact.
  Trust trust = Trust::good;  ///< That its file gives it.
  std::string file;
};
/// Of a heft.estimate/1 or a bare payload, in sensor axes; or of a controller's own file (isControllerFile()), which is
/// in flange axes and is brought to the sensor's by `mount`. It must hold what the sensor carries and nothing else.
Result<EnteredPayload> enteredPayloadFromJson(const nlohmann::json& object, const std::string& where,
                                              const SensorMount& mount = {});

struct Proof {
  ProofVerdict verdict = ProofVerdict::cannotTell;
  Findings reasons;  ///< Unless it passes: what is wrong and what to do, the most important first.
  EnteredPayload entered;
  EstimateReport own;  ///< What the recording says by itself.
  /// Entered less own payload, and its standard deviation from the recording's noise, the payload's interval and the
  /// sensor's repeatability: mass, com, Ixx, Ixy, Ixz, Iyy, Iyz, Izz about the centre of mass.
  Vector10d off = Vector10d::Zero(), offStd = Vector10d::Zero();
  double massCentreChi2 = 0.0, inertiaChi2 = 0.0;          ///< Of `off`, 4 and 6 degrees of freedom.
  bool massCentreDiffers = false, inertiaDiffers = false;  ///< By more than chance
  double smallestMass = 0.0, smallestCentre = 0.0;         ///< Errors that this proof would hardly miss [kg], [m]
  Vector6d bias = Vector6d::Zero();                        ///< Of this recording with the entered payload [N], [N m]
  Vector6d left = Vector6d::Zero();   ///< Root mean square of the compensated wrench in the free parts, one a channel
  Vector6d noise = Vector6d::Zero();  ///< The sensor's own scatter from sample to sample, one a channel
};

/// The recording's rows are whitened by the noise that is found in them (coloured, with spikes), its own six biases are
/// eliminated, and the entered payload is held against what the rows say in every direction that the motion excites.
/// Fails where the recording cannot be used at all. `read`: what was said when it was read.
Result<Proof> prove(const EnteredPayload& entered, const Recording& recording, const RobotModel* robot,
                    const EstimateOptions& options, const Findings& read = {}, const Progress& progress = {});

/// heft.prove/1.
nlohmann::json toJson(const Proof& proof);
std::string toText(const Proof& proof);

}  // namespace heft
