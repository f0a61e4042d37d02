#pragma once
// How noisy recorded positions are, and what that does to the motion.
#include <cstdint>
#include <optional>

#include "core/motion/resample.h"
#include "core/recording/recording.h"

namespace heft {

/// Standard deviation of the white noise on each column of `values`, whose rows belong to `time`, as `grid` reads them,
/// by its power from 30 to 45 Hz: no arm moves a tool there. Absent where the grid is slower than 100 Hz or shorter
/// than a second.
std::optional<VectorXd> whiteNoiseOf(const UniformGrid& grid, const VectorXd& time,
                                     const Eigen::Ref<const MatrixXd>& values);

/// The motion of a recording, without its wrench, with as much noise added to its joints, poses and velocities again as
/// there is already: what that changes in the motion is what the noise itself has done, but for its sign (Cook and
/// Stefanski 1994, doi 10.1080/01621459.1994.10476871). The same recording and seed give the same noise. Absent where
/// the noise cannot be told.
std::optional<Recording> noisierMotion(const Recording& recording, std::uint64_t seed = 1);

}  // namespace heft
