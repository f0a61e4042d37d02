#pragma once
// Readings that come once more: a logger that sent its buffer twice, a file whose parts were joined twice.
#include <vector>

#include "core/recording/frozen.h"

namespace heft {

/// Rows that repeat others before them, noise included.
struct Replay {
  FrozenStretch at;       ///< The later ones
  Eigen::Index from = 0;  ///< First of the rows that they repeat
};

/// Stretches with at least `fewest` readings (rows that differ from the row before) whose wrench is that of earlier
/// rows, one by one. Noise does not repeat; where a channel is so coarse that few values come, nothing is said.
/// `wrench`: a row each.
std::vector<Replay> replayedStretches(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench, Eigen::Index fewest);

}  // namespace heft
