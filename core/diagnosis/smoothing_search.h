#pragma once
// The search for causes on the smoothing of the motion that suits the recording.
#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/diagnosis/artefacts/noisy_motion.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/readings.h"
#include "core/diagnosis/search/null_distribution.h"

namespace heft::diagnosis {

/// A search, and the chance of finding something where nothing is.
struct Searched {
  Hypothesis hypothesis;
  double threshold = kThreshold;
  Surrogates chance;  ///< Empty where none were asked for, or nothing was found
  std::optional<NoisyMotion> noisy;
  double cutoffHz = 0.0;  ///< Of the smoothing of the motion
};

/// Accelerations from coarse or late angles are noise above some frequency. Bias and payload alone tell where, unless a
/// cause hides it: then the final model does.
Result<Searched> searched(const Recording& recording, const Readings& readings, const RobotModel* robot,
                          const DiagnoseOptions& options, const Progress& progress);

/// What pulls at the tool hard may look like a sensor that is turned or a sign mixed up: where causes explain more
/// without a mistake, there is none, and `readings` and `found` are those without it.
void unlessCausesExplainMore(const Recording& recording, const RobotModel* robot, DiagnoseOptions options,
                             const Progress& progress, Readings& readings, Searched& found);

}  // namespace heft::diagnosis
