#pragma once
// The prior that an estimate runs with: from the user's shape, or the vague one.
#include "core/base/result.h"
#include "core/estimation/map.h"
#include "core/estimation/options.h"

namespace heft {

struct ChosenPrior {
  MapPrior prior;
  Vector10d start = Vector10d::Zero();  ///< Where the solver begins.
  bool fromUser = false;                ///< A shape was given.
};

/// Fails where the shape itself cannot be used (a broken mesh file).
Result<ChosenPrior> priorFor(const EstimateOptions& options, const Triangle& whitened, Findings& findings);

}  // namespace heft
