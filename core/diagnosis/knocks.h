#pragma once
// Moments at which something knocks: the readings shake for some hundredths of a second, faster than the model follows.
#include <vector>

#include "core/diagnosis/fit.h"

namespace heft::diagnosis {

/// Times [s] of knocks in `stretches`, one each however long it rings.
std::vector<double> knocksIn(const Signals& signals, const std::vector<Stretch>& stretches, const Model& model);

}  // namespace heft::diagnosis
