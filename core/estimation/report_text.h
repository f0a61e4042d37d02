#pragma once
// The numbers of a payload as lines for a person.
#include <string>

#include "core/estimation/estimate.h"

namespace heft {

/// Mass, centre of mass and inertia, a line a number with half its 95 % interval and where it comes from.
std::string numbersText(const EstimateReport& report);

}  // namespace heft
