#pragma once
// Lines in the spectrum of the readings above everything that a hand moves: fans, motors, the mains, what rings.
#include <optional>

#include "core/diagnosis/signals/signals.h"

namespace heft::diagnosis {

struct Hum {
  double frequencyHz = 0.0;
  double force = 0.0, torque = 0.0;  ///< Amplitude over the three axes [N], [N m]
  double share = 0.0;                ///< Of the power above 22 Hz, on the channel where that is most
  bool mains = false;                ///< 50 or 60 Hz or twice that
};

/// The line that stands out most, if any does; `recording` has evenly spaced rows, of which those in usable blocks
/// count.
std::optional<Hum> humIn(const Recording& recording, const Signals& signals);

/// Where the readings ring above what a hand moves [Hz], however broad that is; none where no pitch stands out.
std::optional<double> pitchIn(const Signals& signals);

}  // namespace heft::diagnosis
