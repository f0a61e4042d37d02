#pragma once
// Stretches in which something that was measured stands still.
#include <array>
#include <vector>

#include "core/math/rigid.h"

namespace heft {

/// By row: 0 the same as the row before, 1 one value changed by a step of its resolution (or is the first), 2 by more.
using Changes = std::vector<char>;

/// How each row of a column differs from the row before. Its resolution is the smallest change.
std::vector<Changes> changesOfEach(const Eigen::Ref<const MatrixXd>& values);

/// The largest of all columns, row by row.
Changes ofAny(const std::vector<Changes>& columns);

/// Over all columns.
Changes changesOf(const Eigen::Ref<const MatrixXd>& values);

/// Whether any row differs from the row before.
bool everChanges(const Eigen::Ref<const MatrixXd>& values);
bool everChanges(const Changes& changes);

/// Whether nine of ten changes are a single step, as where the steps are coarser than the noise.
bool inSingleSteps(const Changes& changes);

/// How many of the rows from..to-1 change.
Eigen::Index countIn(const Changes& changes, Eigen::Index from, Eigen::Index to);

/// Rows from..to-1 with the same value.
struct FrozenStretch {
  Eigen::Index from = 0;
  Eigen::Index to = 0;
  Eigen::Index length() const { return to - from; }
};

/// The stretches without change that last at least `shortest` [s] and ten rows and are twenty times longer than is
/// usual, so that slow sensors do not count. A sensor coarser than its noise mostly changes by one step and stays long
/// at one value too: there a stretch counts only if it begins or ends with more than one. `time`: of each row [s].
std::vector<FrozenStretch> frozenStretches(const VectorXd& time, const Changes& changes, double shortest);

/// The stretches of 0.25 s and more in which one channel stands still while others go on: it was not measured there, or
/// the sensor was saturated. `all`: changes of any channel.
std::vector<FrozenStretch> frozenAlone(const VectorXd& time, const Changes& channel, const Changes& all);

/// The stretches of 0.1 s and more in which a posture (a row each) stands still and from which it leaps: a logger that
/// hung; an arm that stood starts gently.
std::vector<FrozenStretch> hungPostures(const VectorXd& time, const Eigen::Ref<const MatrixXd>& postures);

/// Which channels hardly ever read anything else than one value: they were not measured, or say nothing for their
/// steps. `wrench`: a row each.
std::array<bool, 6> silentChannels(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench);

}  // namespace heft
