#pragma once
// Samples that a source measures at even steps and stamps when it passes them on.
#include <vector>

#include "core/math/rigid.h"
#include "core/recording/clock.h"

namespace heft {

/// Times of samples: as they were stamped, or on an even clock that follows the stamps slowly, whichever makes the
/// motion clearly smoother. While the arm stands still neither does, and it makes no difference. Stamps that scatter by
/// more than a fifth of a step are kept: what is lost cannot be told from what is late.
class EvenStamps {
 public:
  EvenStamps() { beginStretch(); }
  /// `stamp` [s], later than the one before; `motion`: joint angles or a pose, as many numbers each time.
  double timeOf(double stamp, VectorXd motion);
  /// Times of the newest samples, once the even clock has been taken for them as well; empty otherwise.
  std::vector<double> corrected() const;
  /// Forgets the samples, not which times were right.
  void beginStretch();
  /// Whether the even clock tells the times.
  bool used() const { return used_; }

 private:
  struct Sample {
    double stamp, even;
    VectorXd motion;
  };
  double followed(double stamp);
  void judge();

  SequenceClock clock_;
  std::int64_t number_ = 0;
  double even_ = 0.0, step_ = 0.0;  ///< [s] Of the newest sample; usual, 0 while unknown
  int early_ = 0;                   ///< Samples in a row that came a step before they were due
  Eigen::Index settled_;            ///< From which one of `recent_` on the clock is steady
  std::vector<Sample> recent_;
  bool used_ = false, changed_ = false;
};

}  // namespace heft
