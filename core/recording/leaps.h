#pragma once
// Rows at which the arm is elsewhere than it can have got to: rows are missing, or two recordings were joined.
#include <vector>

#include "core/recording/recording.h"

namespace heft {

/// Rows at which a joint is more than 0.2 rad from the row before, faster than 30 rad/s. `time`: of each row [s];
/// `joints`: a row each [rad].
std::vector<Eigen::Index> jointLeaps(const VectorXd& time, const Eigen::Ref<const MatrixXd>& joints);
/// The same of orientations, as quaternions.
std::vector<Eigen::Index> orientationLeaps(const VectorXd& time, const Eigen::Ref<const MatrixXd>& quaternions);
/// The same of positions [m]: by more than 0.1 m, faster than 30 m/s.
std::vector<Eigen::Index> positionLeaps(const VectorXd& time, const Eigen::Ref<const MatrixXd>& positions);

/// All of them, rising: of the orientation where it was recorded, else of the joints, and of the position.
std::vector<Eigen::Index> postureLeaps(const Recording& recording);

/// So far around a leap [s] filters make of it what no arm did: the slowest poles of a low-pass of 12 Hz die down at
/// 20/s, and a leap is thousands of times what arms do.
constexpr double kAroundLeap = 0.7;

/// Longer gaps between rows are left out of an estimate [s]: what lies between would be made up. One of its blocks.
constexpr double kGapLeftOut = 0.02;

}  // namespace heft
