#pragma once
// What jumps of a sensor's zero go with.
#include "core/diagnosis/model/fit.h"

namespace heft::diagnosis {

/// Whether a channel jumps each time that its own reading passes one value, up on the way up and back on the way down,
/// or the other way round: an amplifier that is not the same on both sides of it. No zero does.
bool jumpWithTheirReading(const Signals& signals, const Model& model);

}  // namespace heft::diagnosis
