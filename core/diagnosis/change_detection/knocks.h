#pragma once
// Moments at which something knocks: the readings shake for some hundredths of a second, faster than the model follows;
// bursts, which blocks still show; and single readings that are plainly wrong.
#include <optional>
#include <vector>

#include "core/diagnosis/model/fit.h"

namespace heft::diagnosis {

/// Times [s] of knocks in `stretches`, one each however long it rings.
std::vector<double> knocksIn(const Signals& signals, const std::vector<Stretch>& stretches, const Model& model);

/// Times [s] of parts of `stretches`, a third of a second each, in which what the fit leaves is many times louder on
/// some channel than it usually is, where the motion is as well known as elsewhere.
std::vector<double> burstsIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit);

/// Whether the noise is several times louder in some parts than in others that move alike, again and again: something
/// runs there, or is switched on.
bool noiseSwitches(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit);

/// The time [s] of the block in `stretches` in which most is left by far, more than noise of any kind ever leaves: one
/// moment at which a reading is plainly wrong. None where there is no such block.
std::optional<double> glitchIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit);

}  // namespace heft::diagnosis
