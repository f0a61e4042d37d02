#pragma once
// Is there anything left that goes with the motion, whatever its form? Flexible models that name nothing.
#include "core/diagnosis/model/correlate.h"
#include "core/diagnosis/model/fit.h"

namespace heft::diagnosis {

struct Structure {
  Correlate goesWith;
  double gain = 0.0;                 ///< Evidence of the best flexible model
  double share = 0.0;                ///< Of the residual's energy, in units of its noise
  double lowHz = 0.0, highHz = 0.0;  ///< Band in which most of it lies
};

/// The strongest structure in what the fit leaves over; gain below zero if there is none. Whether one that gains less
/// than `least` is there by chance is not asked.
Structure structureIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                      double least = 10.0);

/// The same for a fit from which a zero that walks was taken, which explains nearly `enough`: the load of a while ago
/// may do so, too.
Structure structureBehindWalk(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                              double enough);

}  // namespace heft::diagnosis
