#pragma once
// Samples to regressor blocks with one smoothing, a little behind the newest sample.
#include "core/online/sample_stream.h"
#include "core/wrench/rows.h"

namespace heft {

/// Between two looks at the data [s]: each smooths 1.2 s anew.
constexpr double kStepTime = 0.1;

/// LaneBlocks in time order; stretches follow one another.
struct LaneBlocks {
  double rateHz = 0.0;
  std::vector<double> time;  ///< Of each block's centre [s]
  std::vector<Regressor> Y;
  std::vector<Vector6d> wrench;
  std::vector<char> usable;  ///< 0 beside the ends of a stretch, where smoothing is worst

  Eigen::Index size() const { return static_cast<Eigen::Index>(time.size()); }
  WrenchRows rows(Eigen::Index from, Eigen::Index to) const;
  /// Takes over [from, to) of `other`.
  void append(const LaneBlocks& other, Eigen::Index from, Eigen::Index to);
  void append(const WrenchRows& other, Eigen::Index from, Eigen::Index to, bool use);
  void keep(Eigen::Index from, Eigen::Index to);
};

/// Runs the batch's own smoothing over overlapping windows. A window reaches so far beyond what is kept of it that the
/// filter's transients have died down to rounding: the blocks are those of the batch.
class Lane {
 public:
  explicit Lane(double cutoffHz) : cutoffHz_(cutoffHz) {}

  double cutoffHz() const { return cutoffHz_; }
  /// How far blocks stay behind the newest sample [s].
  double delay() const { return 15.0 / cutoffHz_; }

  /// Appends what has become ready: in steps of kStepTime at 25 Hz where it is shown (`eager`), of two seconds where
  /// it only stands by. With `last` everything that is left. False if nothing was.
  bool advance(const SampleStream& stream, const RobotModel* robot, bool eager, bool last);
  /// A new stretch begins.
  void beginStretch() { next_ = 0; }
  /// The first grid instant that is still needed.
  Eigen::Index needed() const { return needed_; }

  LaneBlocks blocks;
  LaneBlocks newest;  ///< Beyond `blocks`, up to 0.1 s before the newest sample: good enough to notice a contact.
  Findings findings;

 private:
  double cutoffHz_;
  Eigen::Index next_ = 0;  ///< Next block of this stretch
  Eigen::Index needed_ = 0;
};

}  // namespace heft
