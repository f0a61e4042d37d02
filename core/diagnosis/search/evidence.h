#pragma once
// What evidence (calibration.h) says of causes by their family.
#include <cstddef>
#include <string_view>

#include "core/diagnosis/calibration.h"

namespace heft::diagnosis {

/// Readings late or smoothed, or the recorded motion.
bool lags(std::string_view cause);

/// Makes fast forces larger than the motion says.
bool enlarges(std::string_view cause);

/// Whether a cause that goes on all the time and is no drift explains so much of what a walk of the zero does that it
/// is named instead. In 98 recordings whose zero walked, none came to half of it.
bool isMoreThanWalk(std::string_view cause, double gain, double walk);

constexpr std::size_t kRivals = 5;    ///< Causes that get a fit in the place of another
constexpr std::size_t kFinished = 4;  ///< Of these, how many are fitted to the end

}  // namespace heft::diagnosis
