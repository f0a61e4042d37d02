#pragma once
// Channels that are cut off at one value.
#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

namespace heft {

/// A value that a channel does not pass, on one side.
struct FlatTop {
  int channel = 0;  ///< 0 to 2: force [N], 3 to 5: torque [N m]
  double level = 0.0;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> runs;  ///< Rows [from, to) at the level, in order
};

/// Where readings pile up at a value near the largest or smallest of a channel: many times more than at the values next
/// to it, which noise alone leaves ever emptier towards the end. Spikes may lie beyond. Rows that repeat the one before
/// as a whole, and rows of zeros, count for nothing. Nothing is said of a channel whose steps are so coarse that it
/// mostly stands still: there a smooth signal piles up by itself; nor of zeros, where small readings are lost.
std::vector<FlatTop> flatTops(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench);

/// Which channels are cut off in more than half of the rows: they say next to nothing.
std::array<bool, 6> mostlyCutOff(const std::vector<FlatTop>& tops, Eigen::Index rows);

}  // namespace heft
