#pragma once
// Readings that come in steps.
#include <optional>
#include <vector>

#include "core/math/rigid.h"

namespace heft {

/// The step of which all readings lie whole numbers apart, as a coarse converter leaves them, in their unit. None where
/// they do not, or where fewer than four of them differ.
std::optional<double> stepOf(std::vector<double> readings);

/// The steps that the channels of a wrench come in, and what moves the readings over them.
struct ReadingSteps {
  Vector6d step = Vector6d::Zero();       ///< Of each channel [N, N m]; zero where there are none
  Vector6d changes = Vector6d::Zero();    ///< Readings that differ from the one before
  Vector6d crossings = Vector6d::Zero();  ///< Steps that the load passes; what noise passes to and fro is not counted.
  Vector6d dither = Vector6d::Zero();     ///< Noise from one reading to the next, standard deviation [N, N m]
  double duration = 0.0;                  ///< [s]

  /// Standard deviation that rounding to its steps alone gives a channel's mean over `seconds` [N, N m], where such
  /// means are taken as independent. A step s leaves s / sqrt(12) in each reading (Widrow and Kollar 2008, Quantization
  /// Noise, chapter 5). What of it follows from the load stays the same until the load passes the next step, so that
  /// each crossing is one independent error, and the whole recording at least one; noise before the rounding takes
  /// exp(-(2 pi dither / s)^2) of its variance away (the same, chapter 9) and makes of it what is new in each reading
  /// that changes.
  Vector6d roundingNoise(double seconds) const;
};
/// `wrench`: readings, a row each, over `duration` [s]; a pose lasts 1 s.
ReadingSteps readingSteps(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench, double duration);

}  // namespace heft
