#pragma once
// Angles or poses so noisy that accelerations worked out from them, with the usual smoothing, hide what the sensor can
// see.
#include <optional>

#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

struct NoisyMotion {
  WrenchRms usual, smoothed;  ///< Left over by bias and payload with the usual smoothing, and with as much as is needed
  double cutoffHz = 0.0;      ///< Of that smoothing
  bool plain = false;         ///< Noisier than a robot's encoders are; otherwise the sensor is just a quiet one
};

/// None where more smoothing hardly helps. `evidence`: of `smoothed` over `usual`, by bias and payload alone.
std::optional<NoisyMotion> noisyMotion(const Recording& recording, const SmoothingCandidate& usual,
                                       const SmoothingCandidate& smoothed, double evidence);

}  // namespace heft::diagnosis
