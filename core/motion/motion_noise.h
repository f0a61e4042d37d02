#pragma once
// How noisy recorded positions are, and what that does to the motion.
#include <optional>

#include "core/motion/low_pass.h"
#include "core/recording/recording.h"

namespace heft {

/// Standard deviation of the white noise on each channel of a signal that is uniform at `rateHz`, by its power from 30
/// to 45 Hz: no arm moves a tool there. Absent where the signal is slower than 100 Hz or shorter than a second.
std::optional<VectorXd> whiteNoiseOf(const Channels& signal, double rateHz);

/// The recording with as much noise added to its joints, poses and velocities again as there is already: what that
/// changes in the motion is what the noise itself has done, but for its sign (Cook and Stefanski 1994, doi
/// 10.1080/01621459.1994.10476871). The same recording gives the same noise. Absent where the noise cannot be told.
std::optional<Recording> noisierMotion(const Recording& recording);

}  // namespace heft
