#pragma once
// How far parameters that a diagnosis states lie from what was hidden, in its own deviations.
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/simulation/effects/truth.h"

namespace heft::test {

/// One number a parameter that means the same on both sides; none for forms that the catalogue describes otherwise.
/// `cause`: an element of "causes" in heft.diagnose/1.
std::vector<double> parameterErrors(const EffectTruth& hidden, const nlohmann::json& cause);

}  // namespace heft::test
