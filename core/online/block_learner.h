#pragma once
// From blocks to an estimate: thoroughly now and then, quickly in between.
#include <optional>

#include "core/estimation/fit_rows.h"
#include "core/estimation/prepare.h"
#include "core/estimation/prior.h"
#include "core/estimation/triangle.h"
#include "core/online/lane.h"
#include "core/payload/shape_prior.h"

namespace heft {

/// The batch's way from blocks to a noise model: labels, runs, noise. Empty runs where too little is free.
Prepared learnedFrom(const LaneBlocks& blocks);
/// The same with labels that are known.
Prepared learnedWith(const LaneBlocks& blocks, std::vector<MarkLabel> labels);
/// Without the first `count` blocks.
Prepared withoutFirst(const Prepared& prepared, Eigen::Index count);

/// Where the motion is smoothed more than the wrench: the blocks of the motion that lost least, of which motion and
/// wrench are narrowed alike, as in the batch. As long as those that are learned from, or some blocks shorter.
struct WideBand {
  WrenchRows blocks;
  int stride = 1;  ///< FitRowsQuestion::predicts; 1: what is learned from is fitted to as it is.

  WideBand withoutFirst(Eigen::Index count) const;
};

enum class Judged : char { unused, free, contact };

/// What the estimate rests on, for one tool.
class BlockLearner {
 public:
  /// `shape` is the prior of the options' shape, or null; both outlive this.
  BlockLearner(const EstimateOptions* options, const ShapePrior* shape) : options_(options), shape_(shape) {}

  /// Learns labels, noise and prior from all blocks and estimates with intervals by sampling. Does nothing if
  /// too little is free. The shortfall of what the noise was learned from is drawn again where `afresh`, or where the
  /// number of blocks has changed much.
  void learn(const Prepared& prepared, const WideBand& wide, bool afresh = false);
  /// Judges the blocks that came since, and takes them in; with a stride they count when learned from again.
  void follow(const LaneBlocks& blocks);
  /// The first `count` blocks are about to be dropped: what they say is kept. To be followed by learn().
  void freeze(const Prepared& prepared, Eigen::Index count, const WideBand& wide);

  bool estimated() const { return estimated_; }
  Eigen::Index learnedBlocks() const { return learned_; }
  const std::vector<Judged>& judged() const { return judged_; }  ///< Of each block seen so far.
  Eigen::Index usedBlocks() const { return frozenBlocks_ + used_ + freshBlocks_; }

  /// Largest residual of a block over what is allowed; above 1 something pushes.
  double score(const Regressor& Y, const Vector6d& wrench) const;
  /// Typical size of a free block's residual in each channel.
  const Vector6d& scatter() const { return scatter_; }

  const MapSolution& solution() const { return solution_; }
  const Triangle& total() const { return total_; }
  const MapPrior& prior() const { return chosen_.prior; }
  const ToldParts& told() const { return chosen_.told; }
  const Findings& findings() const { return findings_; }
  const NoiseModel& noise() const { return noise_; }
  const NoiseModel& weighting() const { return weighting_; }
  const PayloadInterval& interval() const { return interval_; }
  /// Rows of the frozen free blocks, unweighted.
  const Triangle& frozenRows() const { return frozenRows_; }

 private:
  void forgetBlocks();
  void judge(const LaneBlocks& blocks);
  void solve(bool sampled);

  const EstimateOptions* options_;
  const ShapePrior* shape_;
  bool estimated_ = false;
  int stride_ = 1;
  Eigen::Index learned_ = 0, followed_ = 0;  ///< LaneBlocks learned from; and those whose rows are in fresh_.
  std::vector<Judged> judged_;
  std::optional<Vector3d> still_;  ///< What was learned from stood still: with this specific force.
  NoiseModel noise_, weighting_;
  std::optional<double> shortfall_;  ///< shortfallOfLearning(), of so many blocks:
  Eigen::Index shortfallOf_ = 0;
  Triangle frozen_ = Triangle::Zero(), frozenRows_ = Triangle::Zero(), base_ = Triangle::Zero(),
           total_ = Triangle::Zero();
  Eigen::Index frozenBlocks_ = 0, used_ = 0, freshBlocks_ = 0;
  std::optional<TriangleBuilder> fresh_{std::in_place};
  Vector6d scatter_ = Vector6d::Ones();
  Eigen::Matrix<double, kColumns, kColumns> covariance_;  ///< Of [bias, phi], of the linear problem.
  ChosenPrior chosen_;
  Findings findings_;  ///< About the prior
  MapSolution solution_;
  PayloadInterval interval_;
  /// Sampled intervals over those of the curvature, lower and upper half, when last learned.
  Vector10d lowerRatio_ = Vector10d::Ones(), upperRatio_ = Vector10d::Ones();
};

}  // namespace heft
