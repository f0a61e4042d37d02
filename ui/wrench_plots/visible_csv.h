#pragma once
// What the plots show as a table for other programs.
#include <string>

#include "ui/wrench_plots/wrench_traces.h"

namespace heft {

/// CSV of the measured samples within [from, to]: time, the six measured channels and, where there is an estimate, the
/// simulated ones and the differences, interpolated to the samples' times. SI units, sensor axes, decimal point.
std::string visibleCsv(const WrenchTraces& traces, double from, double to);

}  // namespace heft
