#pragma once
// Angles or poses that are not what was measured at each row, but a few readings with straight lines between them, or
// rounded to coarse steps.
#include <optional>

#include "core/recording/recording.h"

namespace heft::diagnosis {

struct CoarseMotion {
  double every = 0.0;      ///< [s] Time from one corner to the next of straight lines; 0: there are none
  double stepAngle = 0.0;  ///< [rad] Of the joint angles' steps; 0: they are fine, or there are none
  double stepPlace = 0.0;  ///< [m] The same of positions
};

/// None where the motion is recorded fast and finely enough for accelerations to come from it.
std::optional<CoarseMotion> coarseMotion(const Recording& recording);

}  // namespace heft::diagnosis
