#pragma once
// What seems to be contact and is none: it goes with the motion, the load or the sensor, as no touch does.
#include <string>
#include <vector>

#include "core/diagnosis/change_detection/segments.h"

namespace heft::diagnosis {

/// What the fit leaves in the contacts goes with, where each can be told from the others, as no push can; empty
/// otherwise.
Correlate lawOf(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts);

}  // namespace heft::diagnosis
