#pragma once
// Readings that come in steps.
#include <optional>
#include <vector>

#include "core/math/rigid.h"

namespace heft {

/// The step of which all readings lie whole numbers apart, as a coarse converter leaves them, in their unit. None where
/// they do not, or where fewer than four of them differ.
std::optional<double> stepOf(std::vector<double> readings);

/// The steps that the channels of a wrench come in.
struct ReadingSteps {
  Vector6d step = Vector6d::Zero();     ///< stepOf() each channel [N, N m]; zero where there are none
  Vector6d changes = Vector6d::Zero();  ///< Readings that differ from the one before
  double duration = 0.0;                ///< [s]

  /// Standard deviation that rounding to its steps alone gives a channel's mean over `seconds` [N, N m]. A step s leaves
  /// s / sqrt(12) in each reading (Widrow and Kollar 2008, Quantization Noise, chapter 5); readings that only repeat the
  /// one before are no further ones.
  Vector6d roundingNoise(double seconds) const;
};
/// `wrench`: a row each, over `duration` [s].
ReadingSteps readingSteps(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench, double duration);

}  // namespace heft
