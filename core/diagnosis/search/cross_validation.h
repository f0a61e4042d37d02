#pragma once
// What a cause gains on stretches that its parameters were not fitted to.
#include "core/diagnosis/model/fit.h"

namespace heft::diagnosis {

struct Gain {
  double forceBefore = 0, forceAfter = 0;    ///< rms [N]
  double torqueBefore = 0, torqueAfter = 0;  ///< rms [N m]
  double explainedFraction = 0;              ///< Share of the squared misfit, in units of the noise, that goes away
  double lower = 0, upper = 0;               ///< 95 % interval of that share, from the scatter between blocks
  int blocksBetter = 0, blocks = 0;
};

/// Residual of every usable block under parameters fitted without it: ten parts in turn, with gaps of half a second.
/// The noise model is the fit's own.
Wrenches heldOutResidual(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit);

/// Payloads fitted without each of these parts in turn, one a column.
Eigen::Matrix<double, 10, Eigen::Dynamic> payloadsWithoutParts(const Signals& signals,
                                                               const std::vector<Stretch>& stretches, const Fit& fit);

/// Compares two such residuals part by part, in units of `noise`.
Gain gainOf(const std::vector<Stretch>& stretches, const Noise& noise, const Wrenches& before, const Wrenches& after);

}  // namespace heft::diagnosis
