#pragma once
// A bit of a converter that never changes: its channel never reads every other step of that bit's worth.
#include <vector>

#include "core/recording/recording.h"

namespace heft::diagnosis {

struct StuckBit {
  Eigen::Index channel = 0;
  double worth = 0.0;  ///< [N, N m] How wide each step is that never occurs
};

/// Channels whose readings leave out steps that are equally wide and equally far apart, by twice their width. Coarse
/// readings leave out all but single values, and a dead band leaves out one step: neither is meant.
std::vector<StuckBit> stuckBits(const Recording& recording);

}  // namespace heft::diagnosis
