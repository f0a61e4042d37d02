#pragma once
// What a solution is judged by, and what the user should know about it.
#include <functional>

#include "core/estimation/estimate.h"
#include "core/estimation/prepare.h"
#include "core/estimation/solvers.h"

namespace heft {

/// Root mean squares of measured minus predicted wrench [N], [N m].
struct Residuals {
  double force = 0, torque = 0;
  Vector6d channels = Vector6d::Zero();
};

/// Over the samples of the used blocks; each block is predicted by its own solution (held-out checks).
Residuals residualsOver(const Prepared& prepared,
                        const std::function<const SolverSolution&(Eigen::Index block)>& solutionOf);

/// Says where a rigid tool does not explain the data, in numbers that need no statistics.
void judgeFit(const Prepared& prepared, const Residuals& heldout, EstimateReport& report);

/// What is not known, not physical or not usable.
void addFindings(EstimateReport& report);

}  // namespace heft
