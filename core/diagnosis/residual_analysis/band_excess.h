#pragma once
// Where a residual has more power than a sensor's noise would, band by band: for what swings at no one frequency.
#include "core/diagnosis/model/fit.h"

namespace heft::diagnosis {

struct BandExcess {
  double excess = 0.0;  ///< Over the limit that no noise of a sensor reaches
  double share = 0.0;   ///< Of the residual's power below 20 Hz
  double lowHz = 0.0, highHz = 0.0;
};

/// The slow band, below 4 Hz, whose power density stands highest above that of the residual's own fast noise, 8 to 20
/// Hz.
BandExcess slowExcess(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual);

/// The band between 5 and 22 Hz that stands highest above what is both slower and faster: what shakes the tool from
/// outside, such as a conveyor that changes its speed.
BandExcess shakingIn(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual);

/// Whether what is slow is on some channels only: many times further above the fast noise on one than on another that
/// measures the same (force or torque); or on torques and hardly any force, as where a payload's mass moves. A zero
/// that walks does so on all channels: of 76 clean recordings, 17 of which walked, no channel had more than 19 times
/// what another of its kind had.
bool isUneven(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual);

}  // namespace heft::diagnosis
