#pragma once
// Conventions that are not as stated, as the diagnosis has them: core/conventions decides which, and they are put right
// in the recording before any cause is looked for.
#include <optional>
#include <vector>

#include "core/conventions/check.h"
#include "core/diagnosis/model/fit.h"

namespace heft::diagnosis {

struct FrameMistake {
  conventions::Reading stated, reading;        ///< What the recording was taken for, and what it is
  std::vector<conventions::Change> changes;    ///< From the one to the other; never empty
  bool positionsKept = false;                  ///< Of inverted poses: only the orientations are, positions are in B
  double evidence = 0.0;                       ///< 2 ln L over what is stated
  bool tied = false;                           ///< Another reading with another payload fits as well.
  std::vector<conventions::Alternative> ties;  ///< What fits as well, likeliest first
  std::string decides;                         ///< What would decide a tie
  Vector3d turnStd = Vector3d::Zero();         ///< Of a turned mount [rad]
  std::optional<double> forceBefore;           ///< What bias and payload leave of the force as stated, RMS [N]

  bool has(conventions::Change change) const;
  bool only(conventions::Change change) const { return changes.size() == 1 && has(change); }
  /// Of the readings, in stated sensor axes.
  Matrix3d turn() const { return reading.turn * stated.turn.transpose(); }
  std::string sentence() const;
  std::string check() const;
};

/// The conventions that have to be put right; nothing if the recording is understood as stated, or nothing fits.
std::optional<FrameMistake> frameMistake(const Recording& recording, const Motion& motion,
                                         const conventions::Report& report);

/// Finds the turn of a mount once more, beside all that a payload does and with the noise as it is: `right` has the
/// turn of `mistake` undone.
void refineTurn(FrameMistake& mistake, const Signals& right, const std::vector<Stretch>& stretches);

}  // namespace heft::diagnosis
