#pragma once
// Small made-up recordings and results with known contents.
#include "core/estimation/estimate.h"
#include "core/recording/recording.h"

namespace heft::test {

/// Force x = 10 sin(2 pi t), y = 3, z = -5 + t; torques a tenth of it; `rows` samples at `rateHz`.
Recording sineRecording(Eigen::Index rows, double rateHz);

/// 0.812 kg, everything measured, simulated = measured - 0.25 N in x; contact between 40 % and 50 % of the duration.
EstimateReport reportOn(const Recording& recording);

}  // namespace heft::test
