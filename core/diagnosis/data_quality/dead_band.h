#pragma once
// Drivers that give zero for what is small, or for everything.
#include <optional>
#include <vector>

#include "core/diagnosis/data_quality/held_rows.h"
#include "core/segmentation/flat_tops.h"

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

/// The wrench with straight lines in the place of rows that are zero (zeroRuns()) and of what `bands` hide.
Eigen::Matrix<double, Eigen::Dynamic, 6> withoutZeros(const Recording& recording, const std::vector<DeadBand>& bands);

/// A channel that stands still for a while in which others go on.
struct FrozenChannel {
  Eigen::Index channel = 0;
  double from = 0.0, to = 0.0;  ///< [s]
};

/// The longest such while, of at least 0.3 s and twenty times what the channel does otherwise; not at the end of its
/// range (`tops`), nor where it is zero for all that is small. Where any channel of a kind comes in
/// coarse steps (`steps`, as of CoarseReadings), all of that kind may stand still by themselves.
std::optional<FrozenChannel> frozenChannel(const Recording& recording, const std::vector<FlatTop>& tops,
                                           const Vector6d& steps);

}  // namespace heft::diagnosis
