#pragma once
// Readings of a coarse converter.
#include <array>
#include <optional>

#include "core/recording/recording.h"

namespace heft::diagnosis {

struct CoarseReadings {
  /// Of each channel [N, N m] whose readings come in steps so coarse that they stand still while the load changes; zero
  /// for the others. A channel that hardly leaves one step has that of the others of its kind.
  Vector6d steps = Vector6d::Zero();
  std::array<bool, 6> silent{};  ///< As of silentChannels()
};

CoarseReadings coarseReadings(const Recording& recording);

/// A channel that hardly ever reads anything else than one value, though not for its steps.
std::optional<Eigen::Index> stuckChannel(const CoarseReadings& coarse);

/// Readings of channels that hardly ever leave one step are moved to anywhere within it, slowly and always in the
/// same way: what a step hides is not known, and a channel that never changes would pass for one without noise.
/// `wrench`: a row each of the recording.
void spreadWithinSteps(const Recording& recording, const CoarseReadings& coarse,
                       Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, 6>> wrench);

}  // namespace heft::diagnosis
