#pragma once
// How often a sensor said something new.
#include <Eigen/Core>
#include <utility>
#include <vector>

namespace heft {

using Runs = std::vector<std::pair<Eigen::Index, Eigen::Index>>;  ///< Of rows [from, to)

/// Rows that hold one and the same wrench, in order: all rows are in one of them.
Runs wrenchRuns(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench);

/// Straight lines from the row before each run to the row behind it, in every column of `readings`. `time` [s].
void straightOver(const Runs& runs, const Eigen::VectorXd& time, Eigen::Ref<Eigen::MatrixXd> readings);

}  // namespace heft
