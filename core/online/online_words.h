#pragma once
// The excitation lights: what the motion so far tells, in a word and a sentence.
#include "core/online/online_estimator.h"

namespace heft {

/// Fills mass, com and inertia of `state` from its payload, standard deviations and identifiability.
void judgeExcitation(OnlineState& state);

}  // namespace heft
