#pragma once
// Values of a recording between its rows, by a straight line, for instants that are asked for in rising order.
#include <algorithm>

#include "core/math/rigid.h"

namespace heft::diagnosis {

class BetweenRows {
 public:
  /// `time`: the recording's, at least one row; must outlive this.
  explicit BetweenRows(const VectorXd& time) : time_(time) {}

  /// Row of `values` (a row for each of the recording's) at time t [s]; held before the first row and after the last.
  template <class Values>
  auto at(const Values& values, double t) {
    while (row_ + 2 < time_.size() && time_(row_ + 1) < t) ++row_;
    const Eigen::Index next = std::min(row_ + 1, time_.size() - 1);
    const double step = time_(next) - time_(row_);
    const double share = step > 0.0 ? std::clamp((t - time_(row_)) / step, 0.0, 1.0) : 0.0;
    return ((1.0 - share) * values.row(row_) + share * values.row(next)).eval();
  }

 private:
  const VectorXd& time_;
  Eigen::Index row_ = 0;
};

}  // namespace heft::diagnosis
