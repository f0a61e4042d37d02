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

/// By how many standard deviations, as before, the mass, the centre of mass (x, y, z) and the inertia about it (xx, xy,
/// xz, yy, yz, zz) change where the causes are taken out; 0 where a deviation is unknown.
Vector10d payloadShift(const DiagnosisReport& report);

}  // namespace heft
