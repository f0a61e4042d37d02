#pragma once
// How often a sensor said something new.
#include <Eigen/Core>
#include <utility>
#include <vector>

namespace heft {

/// Rows [from, to) that hold one and the same wrench, in order: all rows are in one of them.
std::vector<std::pair<Eigen::Index, Eigen::Index>> wrenchRuns(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench);

}  // namespace heft
