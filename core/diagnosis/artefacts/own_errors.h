#pragma once
// What our own smoothing and resampling of the motion leave looks like causes of the rig.
#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

/// Whether they, or our bringing two clocks together, leave all that the final model has of `found`. A mount that
/// swings enlarges what the smoothing took; where little speaks for it, corners of the motion may be all that does.
bool ownErrors(const Hypothesis& hypothesis, const Found& found);

/// Whether all of `found` may come of bringing two clocks together.
bool madeByAlignment(const Hypothesis& hypothesis, const Found& found);

/// Says what of the final model is `aligned`, which is madeByAlignment(). `std` [s]: Signals::clockAlignmentStd.
void sayAlignment(const std::vector<DiagnosedCause>& aligned, double std, DiagnosisReport& out);

/// Says what much speaks for and is not named: `own` are those of ownErrors() that are part of the final model.
void sayOwnErrors(const std::vector<Found>& own, DiagnosisReport& out);

/// Says that the motion was smoothed to `cutoffHz`, if that hides much: `evidence` over the usual smoothing.
void saySmoothing(double cutoffHz, double evidence, DiagnosisReport& out);

}  // namespace heft::diagnosis
