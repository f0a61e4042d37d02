#pragma once
// Events again and again: a gripper that opens and closes, a valve that switches.
#include "core/diagnosis/model/noise.h"

namespace heft::diagnosis {

/// A moment at which the residual leaps further than it does elsewhere.
struct StepCandidate {
  double time = 0.0;  ///< [s]
  double size = 0.0;  ///< Squared deviations of what it does elsewhere, all six channels
};

/// In the order of time. `over`: [s] before and after a moment, of which the means are compared.
std::vector<StepCandidate> stepCandidatesIn(const Signals& signals, const std::vector<Stretch>& stretches,
                                            const Wrenches& residual, double over = 0.2);

}  // namespace heft::diagnosis
