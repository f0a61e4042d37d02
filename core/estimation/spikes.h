#pragma once
// Readings that no force made: single ones far off, and discharges that die away within a few rows.
#include <Eigen/Core>
#include <optional>

namespace heft {

using WrenchSamples = Eigen::Matrix<double, Eigen::Dynamic, 6>;  ///< Rows x (fx, fy, fz, tx, ty, tz)

/// The wrench without spikes. Single samples further than eight times the local scatter (by steps between rows, or ten
/// times by bends where the load moves fast) from the median of their seven neighbours, laid along the load's course,
/// take that median; where one channel alone leaps as far and falls back to where it was within 24 rows, a line takes
/// the place of these. Counts the rows in which something was replaced.
WrenchSamples withoutSpikes(const WrenchSamples& wrench, Eigen::Index& replaced);

/// Lines in the place of rows that are zero in every channel and more than a step of its resolution away from those
/// beside them: a source that had no reading sent them. Up to 20 ms at a time; counts the rows. Nothing where there are
/// none, or where half of the rows are. `time` [s].
std::optional<WrenchSamples> withoutZeros(const Eigen::VectorXd& time, const WrenchSamples& wrench,
                                          Eigen::Index& replaced);

}  // namespace heft
