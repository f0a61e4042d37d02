#pragma once
// What seems to be contact and is none: it goes with the motion, the load or the sensor, as no touch does.
#include <string>
#include <vector>

#include "core/diagnosis/change_detection/segments.h"

namespace heft::diagnosis {

/// What the contacts go with by the hypothesis with the best evidence; empty where that is a push, or a load that the
/// tool carries.
Correlate correlateOf(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts);

}  // namespace heft::diagnosis
