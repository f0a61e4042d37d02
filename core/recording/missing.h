#pragma once
// How much a recording may lack.

namespace heft {

inline constexpr double kMissingShare = 0.05;  ///< Up to this share of rows may lack values.

/// Up to which share of rows may lack an accelerometer's readings, to be left out for its sake. Where the sensor's
/// acceleration is known it is a check that rows are not given up for; where it is not, half of them are worth it.
inline double mostWithoutAccelerometer(bool accelerationKnown) { return accelerationKnown ? kMissingShare : 0.5; }

}  // namespace heft
