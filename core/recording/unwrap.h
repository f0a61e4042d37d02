#pragma once
// Joint angles that are kept within one turn (-pi to pi, 0 to 2 pi) jump where they reach its end. The turns are taken
// out before anything is averaged, joined or differentiated.
#include <numbers>
#include <string>
#include <vector>

#include "core/math/rigid.h"

namespace heft {

/// One angle, sample by sample.
class Unwrapper {
 public:
  explicit Unwrapper(double turn = 2.0 * std::numbers::pi) : turn_(turn) {}

  /// `angle` without the turns by which it jumped since the first call. A jump counts as a wrap where only whole turns
  /// bring it back to what a joint can do in `step` [s], the time since the last call. Not finite: returned as it is.
  double next(double angle, double step);
  bool jumped() const { return jumped_; }

 private:
  double turn_;
  double last_ = 0.0;
  double offset_ = 0.0;
  bool any_ = false;
  bool jumped_ = false;
};

/// Unwraps the columns of q [rad]; `time` [s] rises. A joint that wrapped is shifted by whole turns so that the middle
/// of its range is nearest to zero. Returns the joints that wrapped, from 0.
std::vector<int> unwrapJoints(const VectorXd& time, MatrixXd& q);

/// "The angles of q1 and q3 wrap around ...": for a finding.
std::string unwrapped(const std::vector<int>& joints);

}  // namespace heft
