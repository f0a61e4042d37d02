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
  std::size_t at = 0;     ///< Which of the smoothings that is
};

/// Accelerations from coarse or late angles are noise above some frequency. Bias and payload alone tell where, unless a
/// cause hides it: then the final model does.
Result<Searched> searched(const Recording& recording, const Readings& readings, const RobotModel* robot,
                          const DiagnoseOptions& options, const Progress& progress);

/// A long recording as a whole, at fewer instants and in coarser blocks, smoothed as `part` of it was found to need.
/// How likely chance is, is known from there, too.
Result<Searched> searchedOnWhole(const Recording& recording, const Readings& readings, const RobotModel* robot,
                                 const DiagnoseOptions& options, const Searched& part, const Progress& progress);

}  // namespace heft::diagnosis
