#pragma once
// What standing poses tell of the causes of misfit: only gravity acts on the payload, so mass, centre and zero are
// known, and of the causes those that bend them from pose to pose.
//
// Mass, centre and zero are fitted to all poses with residuals that follow a t-distribution of four degrees of freedom
// (Lange, Little & Taylor 1989), so that a few bad poses count little. Causes are added one at a time by BIC. In the
// end bad poses are left out, and intervals come from least squares on the others by Student's t.
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/diagnosis/options.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

/// diagnose() of a recording of kind "poses".
Result<DiagnosisReport> diagnosePoses(const Recording& recording, const RobotModel* robot,
                                      const DiagnoseOptions& options, const Progress& progress);

}  // namespace heft::diagnosis
