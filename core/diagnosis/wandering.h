#pragma once
// A zero that wanders at random looks like a drift, or like a jump, to whoever looks for one.
#include "core/diagnosis/fit.h"

namespace heft::diagnosis {

/// True if the last term of `with`, a drift or a jump of the sensor's zero, explains more than a random walk would: a
/// drift must leave slow waves that are smaller than a walk's (whose amplitudes fall with 1/k), a jump must stand out
/// from the steps that the zero makes at other times.
bool beyondWandering(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& without, const Fit& with);

/// How far a single slow wave in time (below 0.6 Hz) of `residual` stands out from a random walk on top of noise: above 1
/// no walk does that. Judged against the other waves, since a noise with a long memory would swallow it.
double slowWave(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual);

}  // namespace heft::diagnosis
