#pragma once
// Stretches in which something that was measured stands still.
#include <array>
#include <vector>

#include "core/math/rigid.h"

namespace heft {

using Changes = std::vector<char>;  ///< By row: differs from the row before (the first row does).

/// Rows in which any of the columns differs from the row before.
template <class Matrix>
Changes changesOf(const Matrix& values) {
  Changes changes(static_cast<std::size_t>(values.rows()), 0);
  if (!changes.empty()) changes[0] = 1;
  for (Eigen::Index c = 0; c < values.cols(); ++c)
    for (Eigen::Index k = 1; k < values.rows(); ++k)
      changes[static_cast<std::size_t>(k)] |= values(k, c) != values(k - 1, c) ? 1 : 0;
  return changes;
}

/// How many of the rows from..to-1 change.
Eigen::Index countIn(const Changes& changes, Eigen::Index from, Eigen::Index to);

/// Rows from..to-1 with the same value.
struct FrozenStretch {
  Eigen::Index from = 0;
  Eigen::Index to = 0;
  Eigen::Index length() const { return to - from; }
};

/// The stretches without change that last at least `shortest` [s] and ten rows and are twenty times longer than is
/// usual, so that slow or coarse sensors do not count. `time`: of each row [s].
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
