#pragma once
// A tool that stands still: whatever accelerations it seems to have are the noise of its joints, and a fit to them
// would find a small mass, an inertia and a precision of its own making.
#include <optional>

#include "core/estimation/noise_model.h"

namespace heft {

/// The mean specific force of S [m/s2] over the runs if nothing moves in them: no turning beyond 0.02 rad/s, no change
/// of the specific force beyond 0.2 m/s2 (a tilt of one degree). Nothing if something moves, or there are no blocks.
std::optional<Vector3d> stillness(const WrenchRows& rows, const std::vector<Run>& runs);

/// True if the block, too, is no more than noise about that stand.
bool standsStill(const Regressor& Y, const Vector3d& specificForce);

/// The regressor of a tool at rest with this specific force.
Regressor regressorAtRest(const Vector3d& specificForce);

}  // namespace heft
