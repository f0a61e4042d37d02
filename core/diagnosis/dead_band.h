#pragma once
// Drivers that give zero for what is small.
#include <vector>

#include "core/diagnosis/held_rows.h"

namespace heft::diagnosis {

/// A channel that reads exactly the same wherever its reading would be less than `width` [N, N m] away from that.
struct DeadBand {
  Eigen::Index channel = 0;
  double reads = 0.0;  ///< Zero, or what that is once an offset was taken off
  double width = 0.0;
  double share = 0.0;  ///< Of its readings
  Runs runs;           ///< Their rows
};

/// The steps of a coarse converter leave no more of a gap here than elsewhere; a row that is zero on all channels is a
/// lost one.
std::vector<DeadBand> deadBands(const Recording& recording);

}  // namespace heft::diagnosis
