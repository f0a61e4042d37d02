#pragma once
// Waves in what a fit leaves over: rhythms in time, fixed in the sensor or in the world, ripples over a joint's turn
// and over what a channel reads.
#include "core/diagnosis/residual_analysis/whitened_residual.h"

namespace heft::diagnosis {

struct BestWave {
  Judged judged;
  double frequencyHz = 0.0;  ///< In time; 0 for a ripple
};

enum class WaveKind { onChannels, inTheWorld, overJoints, overReadings };

/// The best wave of its kind up to `highestHz`, and others beside it while they pay. Slower ones than 0.6 Hz are
/// slowWave()'s, which knows what a walk does.
BestWave bestWave(const Signals& signals, WaveKind kind, const WhitenedResidual& ground, double lnN, double highestHz);

/// What gears do that turn a joint unevenly, by A sin(n q) and A cos(n q) with n once and twice a turn of a motor: 6N x
/// 4 dof. The accelerations (n dq)^2 A move the payload (ten parameters); only with a robot.
MatrixXd ripplesOfGears(const Signals& signals, const Vector10d& payload);

}  // namespace heft::diagnosis
