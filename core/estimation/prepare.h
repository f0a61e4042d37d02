#pragma once
// Everything that comes before solving: motion, blocks, labels, runs, spikes, noise.
#include "core/base/progress.h"
#include "core/conventions/check.h"
#include "core/estimation/fit_rows.h"
#include "core/estimation/noise_model.h"
#include "core/estimation/options.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

/// Blocks that the noise model and the map estimator work on [Hz].
constexpr double kBlockRate = 50.0;
/// Consecutive parts for held-out checks.
constexpr int kFolds = 5;

struct Prepared {
  Motion motion;
  std::optional<Motion> readings;  ///< At the wrench's own readings, where the log repeats them
  WrenchRows blocks;               ///< About kBlockRate, means of sampled()
  std::vector<MarkLabel> labels;   ///< One a block
  std::vector<Segment> segments;
  std::vector<Run> runs;  ///< Free blocks inside the trim, as contiguous runs
  Eigen::Index usedBlocks = 0;
  double usedDuration = 0.0;             ///< [s]
  std::array<bool, 6> silent{};          ///< Channels that say nothing: their noise is taken to be huge
  Vector6d rounding = Vector6d::Zero();  ///< ReadingSteps::roundingNoise() of a block
  NoiseModel noise;
  Eigen::Matrix<double, 6, Eigen::Dynamic> weights;     ///< Robust weights of the innovations, 0..1
  int stride = 1;                                       ///< FitRows::stride of what was fitted
  std::vector<Triangle> folds;                          ///< Whitened rows, one triangle a fold
  Triangle whitened = Triangle::Zero();                 ///< The whole problem with honest variances
  std::optional<Vector3d> still;                        ///< Specific force, if nothing moves in the runs
  double cutoffHz = 0.0;                                ///< That the motion was smoothed with; 0 for other smoothing
  Eigen::Matrix<double, 6, Eigen::Dynamic> unwhitened;  ///< Innovations of all blocks, used or not, in N and N m
  std::optional<conventions::Report> conventions;       ///< What physics says of them, if that was asked
  bool readAsSuggested = false;                         ///< The motion is understood as it suggests.
  Findings findings;

  /// What the blocks are means of: block k of samples [k, k + 1) x blocks.samplesPerBlock.
  const Motion& sampled() const { return readings ? *readings : motion; }
  bool used(Eigen::Index block) const;
  int foldOf(Eigen::Index block) const;  ///< Of a used block.
};

/// Without a cutoff in the options the motion is smoothed with 25, 12, 6 or 3 Hz, whichever predicts the unsmoothed
/// wrench best: accelerations from coarse or late positions are noise above some frequency, and noise in the regressor
/// pulls every estimate towards zero. Fails with one sentence if nothing is left to estimate from.
/// `checkConventions`: physics is asked what the numbers mean, and obeyed if the options say so.
Result<Prepared> prepare(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                         const Progress& progress, bool checkConventions = false);

/// FitRowsQuestion::atLeast for rows at this rate. Where they are so slow that the low-pass, whose cut-off is lowered
/// for them, takes more than a hundredth of a hand's tremor, motion and wrench are narrowed together.
int strideOfSlowRows(double rateHz);

/// Contiguous blocks of [from, to) that are labelled free, at least `shortest` long.
std::vector<Run> runsOf(const std::vector<MarkLabel>& labels, Eigen::Index from, Eigen::Index to,
                        Eigen::Index shortest);

/// If nothing moves in the runs, `still` is set and the blocks there become those of a tool at rest.
void calm(Prepared& out);

/// From `blocks` and `runs` to `noise`, `weights` and `unwhitened`. `poses`: no block is left out of the noise model.
void learnNoise(Prepared& out, bool poses);

/// How much better (positive) the second preparation predicts the blocks that both use: sum over the channels of the
/// logarithm of the innovations' size, taken where four fifths of them lie below.
double advantage(const Prepared& first, const Prepared& second);
/// Less smoothing is kept unless more of it has this advantage: a fiftieth of the innovations' size in each channel.
constexpr double kWorthSmoothing = 0.12;

}  // namespace heft
