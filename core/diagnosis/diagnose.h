#pragma once
// What does the simulation get wrong? Shows it, names the cause, extends the model and measures the gain.
//
// A rigid payload with a constant bias is fitted to the whole recording (baseline). What it leaves over is searched for
// the causes of the catalogue, one after the other, by the evidence that each adds under autoregressive noise
// (difference of BIC), against a threshold learned on simulated clean recordings with the same motion and noise. What
// fits equally well is said to be equal; what nothing in the catalogue accounts for is said to be unexplained.
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/diagnosis/options.h"
#include "core/diagnosis/result.h"

namespace heft {

/// `robot` may be null where the recording carries poses. Fails like estimate().
Result<DiagnosisReport> diagnose(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                                 const Progress& progress = {});

}  // namespace heft
