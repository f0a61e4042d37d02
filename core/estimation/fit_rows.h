#pragma once
// The rows that a payload is fitted to: the blocks of a prepared recording, or a narrower band of them where the motion
// is too noisy above it.
#include <optional>

#include "core/estimation/noise_model.h"

namespace heft {

/// Motion and wrench pass through the same filter (a Hann window over 2 x `stride` blocks, -6 dB at rate / (2 stride)),
/// and every `stride`-th row is kept: a payload fits the rows as it fits the blocks, whatever the filter takes. Nothing
/// is taken from beyond a run; `runs` become those of the rows that are returned.
WrenchRows narrowed(const WrenchRows& blocks, int stride, std::vector<Run>& runs);

/// A fit's rows with what was learned from them.
struct FitRows {
  WrenchRows rows;
  std::vector<Run> runs;
  int stride = 1;
  NoiseModel noise, weighting;
  Eigen::Matrix<double, 6, Eigen::Dynamic> weights;
  /// Sum of Y^T W Y over the part of Y that is noise, as the rows are weighted: it makes every acceleration look larger
  /// than it was, and every inertia smaller.
  Matrix10d motionNoise = Matrix10d::Zero();
  Triangle asWeighted = Triangle::Zero();  ///< The rows as they are weighted, merged
  Triangle whitened = Triangle::Zero();    ///< The whole problem with honest variances and without that bias
  /// Largest bias that was taken out, in standard deviations of one of the ten parameters.
  double bias = 0.0;
  /// Share of what the fit leaves over that the motion's noise makes.
  double share = 0.0;
  double shortfall = 1.0;  ///< shortfallOfLearning(); `whitened` accounts for it.
};

/// What the noise of the recorded motion makes of the blocks: Y of the same motion with as much noise again, less Y.
struct MotionNoiseRows {
  WrenchRows rows;     ///< As many as there are blocks; zero where it was not asked
  double share = 1.0;  ///< Of the blocks in the runs, for which it was asked
};

/// The band in which the payload is known best, errors by what is not known of the motion's noise counted: all of the
/// blocks, or what is below 1/2, 1/4 or 1/8 of their rate.
struct FitRowsQuestion {
  const WrenchRows& blocks;
  const std::vector<Run>& runs;
  KnownOfNoise known;
  std::optional<MotionNoiseRows> motionNoise;  ///< If it is known
  const LearnedNoise* learned = nullptr;       ///< From the blocks, if that has been done.
  int predicts = 1;                            ///< The stride that predicts the wrench best.
  int atLeast = 1;                             ///< In wider bands motion and wrench are not filtered alike.
  bool fixed = false;                          ///< No other will do.
  std::optional<double> shortfall{};           ///< shortfallOfLearning(), if it is known.
};
FitRows fitRowsOf(const FitRowsQuestion& question);

}  // namespace heft
