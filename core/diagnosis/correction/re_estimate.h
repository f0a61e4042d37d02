#pragma once
// The payload as estimated from a recording that is freed of its causes.
#include <optional>

#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

/// Fills report.before and report.after, and says so where the causes make the payload no better; where they make it
/// impossible the verdict becomes "unexplained". `cleaned`: the recording without what the tests of single readings
/// removed. An error as of estimate().
std::optional<Error> estimateAgain(DiagnosisReport& report, const Recording& recording, Recording cleaned,
                                   const RobotModel* robot, const Hypothesis& hypothesis,
                                   const EstimateOptions& options, const Progress& progress);

}  // namespace heft::diagnosis
