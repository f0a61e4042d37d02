#pragma once
// The search on one recording: its motion smoothed one way, contact set aside, frames put right, causes found.
#include <optional>

#include "core/base/result.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/events.h"
#include "core/diagnosis/frames.h"
#include "core/diagnosis/search.h"
#include "core/motion/motion.h"

namespace heft::diagnosis {

/// The recording with its motion smoothed one way, and what may be judged of it.
struct Way {
  double cutoff = kDefaultCutoffHz;
  Signals signals;
  std::vector<Stretch> holes;  ///< Blocks that automatic segmentation takes for contact
};

/// `cleaned`: `recording` without what the tests of single readings removed; `badRows` (one a row, or none) are not judged.
Result<Way> wayOf(const Recording& recording, const Recording& cleaned, const RobotModel* robot, double cutoff,
                  const DiagnoseOptions& options, const std::vector<bool>& badRows);

/// What bias and payload alone make of each way: evidence on the blocks that all of them judge.
std::vector<double> nullEvidence(const std::vector<Way>& ways);

/// Everything that a search needs, and what it found.
struct Work {
  Signals signals;
  std::vector<Stretch> stretches;
  std::vector<Contact> contacts;
  std::optional<FrameMistake> mistake;
  Search search;
};

Result<Work> worked(const Way& start, const DiagnoseOptions& options, double threshold, const Progress& progress);

/// Evidence of the work's final model when the motion is smoothed another way, less that with its own.
double evidenceAt(const Way& other, const Work& work);

}  // namespace heft::diagnosis
