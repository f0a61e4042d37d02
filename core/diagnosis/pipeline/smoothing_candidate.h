#pragma once
// A recording with its motion smoothed one way: contact looked for, frames put right.
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/diagnosis/model/noise.h"
#include "core/diagnosis/options.h"
#include "core/motion/motion.h"

namespace heft::diagnosis {

/// The recording with its motion smoothed one way, and what may be judged of it.
struct SmoothingCandidate {
  Signals signals;
  double cutoffHz = 0.0;                      ///< Above which next to nothing is left
  std::optional<std::vector<Stretch>> holes;  ///< Blocks that automatic segmentation takes for contact, once looked for
  bool mountTurnReported = false;             ///< A turned mount was put right before
};

/// Of several ways to smooth a motion, the one that is taken unless another is clearly better: those before it smooth
/// less.
constexpr std::size_t kUsualSmoothing = 1;

/// `cleaned`: `recording` without what the tests of single readings removed; `badRows` (one a row, or none) are not
/// judged.
/// `blocksHz`: as for signalsOf().
Result<SmoothingCandidate> smoothingCandidateOf(const Recording& recording, const Recording& cleaned,
                                                const RobotModel* robot, const MotionOptions& smoothing,
                                                const DiagnoseOptions& options, const std::vector<bool>& badRows,
                                                double blocksHz = kBlocksHz);

/// Fills `way.holes` the first time that it is asked: none where marks decide or contact is hidden.
void lookForContact(SmoothingCandidate& candidate, const Recording& cleaned, const DiagnoseOptions& options);

/// Contact that was looked for; what takes most of the time is none.
std::vector<Stretch> holesOf(const SmoothingCandidate& candidate);

/// The stretches of `judged` that the contact on `candidate`, which must have been looked for, leaves; all of them
/// where it takes most of the time, or leaves none.
std::vector<Stretch> untouched(Signals judged, const SmoothingCandidate& candidate);

/// What bias and payload alone make of each way: evidence on the blocks that all of them judge, the contact of the
/// first way left out.
std::vector<double> nullEvidence(const std::vector<SmoothingCandidate>& candidates);

}  // namespace heft::diagnosis
