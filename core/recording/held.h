#pragma once
// A wrench that comes more slowly than the rows: a logger repeats each value until the next one comes.
#include <vector>

#include "core/math/rigid.h"

namespace heft {

/// The readings behind rows that mostly repeat.
struct HeldValues {
  double period = 0.0;  ///< [s] From one reading to the next; 0 where values are not held.
  /// Rows at which a reading was taken, one a period: it was new there, and is late by up to a period in the rows
  /// after.
  std::vector<Eigen::Index> rows;
};

/// Values are held where nine of ten last the same number of rows, give or take one, and more than one. A value that
/// lasts longer counts once a period.
HeldValues heldValues(const VectorXd& time, const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench);

}  // namespace heft
