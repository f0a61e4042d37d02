#pragma once
// Events again and again: a gripper that opens and closes, a valve that switches.
#include "core/diagnosis/noise.h"

namespace heft::diagnosis {

/// Moments [s] at which the residual leaps further than it does elsewhere, in time.
std::vector<double> leapsIn(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual);

}  // namespace heft::diagnosis
