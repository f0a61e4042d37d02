#pragma once
// What a sensor at the end of its range still tells.
#include <Eigen/Core>
#include <vector>

#include "core/segmentation/flat_tops.h"

namespace heft::diagnosis {

/// Readings that lost their top given back, where enough of their neighbours kept theirs.
struct Unclipped {
  Eigen::Matrix<double, Eigen::Dynamic, 6> wrench;
  std::vector<bool> lost;  ///< Rows whose reading says nothing but that it was too much
};

/// In each fiftieth of a second in which at most half of a channel's readings were cut off, those are replaced such
/// that the mean becomes that of the normal distribution which, cut off at that level, loses that share of its readings
/// and has the mean that was read (a censored normal distribution: Tobin 1958). Longer stretches are lost.
Unclipped unclipped(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench, const std::vector<FlatTop>& tops,
                    double rateHz);

}  // namespace heft::diagnosis
