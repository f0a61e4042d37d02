#pragma once
// A diagnosis as JSON and as text.
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/diagnosis/result.h"

namespace heft {

/// The contract's heft.diagnose/1.
nlohmann::json toJson(const DiagnosisReport& report);
std::string toText(const DiagnosisReport& report);
/// What is left unknown, in one sentence; empty where nothing is.
std::string unknownText(const DiagnosisReport& report);

/// By how many standard deviations, as before, the mass and the centre of mass (x, y, z) change where the causes are
/// taken out; 0 where a deviation is unknown.
Eigen::Vector4d payloadShift(const DiagnosisReport& report);

}  // namespace heft
