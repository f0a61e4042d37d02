#pragma once
// What else a named cause could be.
#include <string>
#include <vector>

#include "core/diagnosis/search/search.h"

namespace heft::diagnosis {

/// What could be meant instead, for whoever mends the rig. `held`: readings were repeated. `gravity`: g_B.
std::vector<std::string> alternativesOf(const Found& found, const Fit& fit, bool held, const Vector3d& gravity);

}  // namespace heft::diagnosis
