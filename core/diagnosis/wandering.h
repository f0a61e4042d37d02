#pragma once
// A zero that wanders at random looks like a drift, or like a jump, to whoever looks for one.
#include "core/diagnosis/fit.h"

namespace heft::diagnosis {

/// True if the last term of `with`, a drift or a jump of the sensor's zero, explains more than a random walk would: a
/// drift must leave slow waves that are smaller than a walk's (whose amplitudes fall with 1/k), a jump must stand out
/// from the steps that the zero makes at other times.
bool beyondWandering(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& without, const Fit& with);

/// True if what a wandering zero was taken for in `with` is no random walk but a slow wave: one of its amplitudes towers
/// above what a walk through the others would have.
bool moreThanAWalk(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& without, const Fit& with);

}  // namespace heft::diagnosis
