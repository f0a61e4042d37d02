#pragma once
// Faint causes that are made of the motion's own noise.
#include "core/diagnosis/pipeline/hypothesis.h"

namespace heft::diagnosis {

/// A sensor that remembers its load does not follow what is small: that takes noise out of what is predicted, and fits
/// better where the motion is noisy. Where it explains less than half as much once the motion is smoothed far more, it
/// is nothing of the rig, and neither are lags beside it that go as well: their names. `hypothesis` is of the way that
/// is at `at`; `candidates`: the least smoothed first.
std::vector<std::string> motionArtefacts(const Hypothesis& hypothesis,
                                         const std::vector<SmoothingCandidate>& candidates, std::size_t at);

}  // namespace heft::diagnosis
