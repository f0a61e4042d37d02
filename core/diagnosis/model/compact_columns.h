#pragma once
// Columns of wrenches, kept without the channels in which they are zero.
#include <vector>

#include "core/diagnosis/signals/signals.h"

namespace heft::diagnosis {

/// Columns of 6N rows (row 6 n + channel). Many, such as those of zeros and gains, are about one channel alone and take
/// a sixth of the memory.
class CompactColumns {
 public:
  explicit CompactColumns(const Eigen::Ref<const MatrixXd>& dense);

  Eigen::Index rows() const { return 6 * values_.rows(); }
  Eigen::Index cols() const { return columns_; }
  MatrixXd dense() const;
  /// dense() * v.
  VectorXd times(const VectorXd& v) const;

 private:
  struct Place {
    Eigen::Index column = 0, channel = 0;
  };

  Eigen::Index columns_ = 0;
  std::vector<Place> places_;  ///< Of each column of values_, in order
  MatrixXd values_;            ///< N x places
};

}  // namespace heft::diagnosis
