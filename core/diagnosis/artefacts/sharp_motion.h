#pragma once
// Where the motion turns too sharply for its smoothing, such as where a motor's force jumps: the model is less to be
// trusted there.
#include "core/diagnosis/pipeline/hypothesis.h"

namespace heft::diagnosis {

/// Sets Signals::lost and Signals::lostFast of each way, and Signals::noiseScale, the least smoothed first: by how much
/// the wrench that the payload makes of the motion differs from that of the next smoother one, over the noise. Contact
/// on the usual way must have been looked for. `sharper`: smoothed less than all of them, for what even the first has
/// lost. `held`: readings of the motion stood still and caught up, which looks sharp and says nothing of the payload.
void weighSharpMotion(std::vector<SmoothingCandidate>& candidates, const SmoothingCandidate& sharper, bool held);

/// Evidence that `fit` would gain if the payload moved as motion smoothed less tells, where that stands out from its
/// noise: nothing is fitted for it. 0 where weighSharpMotion() was not asked.
double gainOfSharpMotion(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit);

}  // namespace heft::diagnosis
