#pragma once
// A zero that wanders at random looks like a jump, or like a wave, to whoever looks for one.
#include <string_view>

#include "core/diagnosis/model/fit.h"

namespace heft::diagnosis {

/// True if the last term of `with`, a jump of the sensor's zero or of the load, stands out from the steps that the zero
/// makes at other times.
bool jumpStandsOut(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& without, const Fit& with);

/// How far a slow wave in time (below 0.6 Hz) of `residual` stands out from a random walk on top of white noise, in all
/// channels together: above 1 no walk does that. By the likelihood of the judged blocks alone: gaps cost sight, but
/// look like nothing.
double slowWave(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual);

/// Whether the waves of a fitted walk are one course that all channels take, as those of six walks are not: then the
/// zero drifts, however much more the walk explains of slow noise beside that.
bool isOneCourse(const Model& model);

/// Whether a cause is a way that the zero took: each recording has another one.
bool isCourseOfTheZero(std::string_view cause);

}  // namespace heft::diagnosis
