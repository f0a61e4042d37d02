#pragma once
// The search on one way to see a recording: contact set aside, causes found.
#include <functional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/diagnosis/pipeline/hypothesis.h"

namespace heft::diagnosis {

/// SearchOptions::stopsEarly, of a hypothesis that has come as far.
using StopsEarly = std::function<bool(const Hypothesis& hypothesis, bool isFirst)>;

/// Contact on `candidate` must have been looked for. `stopsEarly`, if any, is asked by the first search, before
/// anything is compared.
Result<Hypothesis> hypothesisOn(const SmoothingCandidate& candidate, const DiagnoseOptions& options, double threshold,
                                const Progress& progress, const StopsEarly& stopsEarly = {});

/// Evidence of the hypothesis's final model when the motion is smoothed another way, less that with its own; next to
/// nothing where it is not believable there.
double evidenceAt(const SmoothingCandidate& other, const Hypothesis& hypothesis);

/// The same for a hypothesis of one cause, which is looked for afresh: parameters that fit a motion smoothed far too
/// much lead astray.
double evidenceAfresh(const SmoothingCandidate& other, const Hypothesis& hypothesis, const DiagnoseOptions& options);

}  // namespace heft::diagnosis
