#pragma once
// A simulation that is like the rig: recordings with the causes that a diagnosis found, on this or another motion.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation/simulate.h"

namespace heft {

struct TwinOptions {
  SimulateOptions simulate;          ///< Motion, seed, rate and noise; the bias is that of the diagnosis.
  std::vector<std::string> without;  ///< IDs of causes that are switched off.
  bool fixed = false;                ///< Sizes as found; otherwise drawn from their intervals with the seed.
  std::optional<Payload> payload;    ///< Carried instead of the diagnosis's payload_after.
};

/// A cause of the diagnosis and what became of it.
struct TwinCause {
  std::string id;
  bool simulated = false;
  std::string why;  ///< Where it is not: one sentence.
};

struct Twin {
  Simulated simulated;  ///< `truth.effects` holds each simulated cause with its sizes.
  std::vector<TwinCause> causes;
};

/// `found`, read from the file `where`, is a heft.diagnose/1. The causes act as the diagnosis models them, with the
/// anchors, axes and delays that it found: what they add to the wrench is computed along the new motion and added
/// before the sensor's noise and steps. Drawn sizes are normal about the found value, each by itself, and stay within
/// what is physically believable; places and shapes stay as found, since with an anchor drawn apart from its stiffness
/// the pull would be another one. Single bad readings, contacts and conventions have no such model and are left out, as
/// is what happened after the new motion ends. Fails where `found` is no such result, does not name a cause of
/// `without`, or where its payload cannot exist.
Result<Twin> simulateTwin(const nlohmann::json& found, const std::string& where, const RobotModel& robot,
                          const TwinOptions& options, const Progress& progress = {});

}  // namespace heft
