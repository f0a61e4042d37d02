#pragma once
// Readings that no force made: single ones far off, and discharges that die away within a few rows.
#include <Eigen/Core>

namespace heft {

using WrenchSamples = Eigen::Matrix<double, Eigen::Dynamic, 6>;  ///< Rows x (fx, fy, fz, tx, ty, tz)

/// The wrench without spikes. Single samples further than eight times the local scatter (by steps between rows, or ten
/// times by bends where the load moves fast) from the median of their seven neighbours, laid along the load's course,
/// take that median; where one channel alone leaps as far and falls back to where it was within 24 rows, a line takes
/// the place of these. Counts the rows in which something was replaced.
WrenchSamples withoutSpikes(const WrenchSamples& wrench, Eigen::Index& replaced);

}  // namespace heft
