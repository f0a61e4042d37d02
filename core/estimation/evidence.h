#pragma once
// What the data said, what the prior said, and how far the prior pulled.
#include <optional>

#include "core/estimation/linear_problem.h"

namespace heft {

struct PriorAlone;
struct ToldParts;

/// All vectors hold mass, com, Ixx, Ixy, Ixz, Iyy, Iyz, Izz about the centre of mass (componentsOf); NaN where nothing
/// can be said.
struct Evidence {
  /// Least squares of the whitened rows without any prior, and its standard deviations: what the motion alone says.
  Vector10d data, dataStd;
  /// Standard deviations that the data alone would give a payload like the result (Cramer-Rao bound): what precision
  /// this motion and noise can give at best without a prior.
  Vector10d best;
  bool hasPrior = false;
  Vector10d prior, priorStd;  ///< What was told, without the data.
  Vector10d shift;            ///< (result - data) / dataStd: how far the prior pulled, in the data's sigmas
  Vector10d disagreement;     ///< (prior - data) over the standard deviation of their difference
  Evidence();
};

/// `R` is whitened; `result` the estimate (physical).
Evidence evidenceOf(const Triangle& R, bool bias, const Vector10d& result, const std::optional<PriorAlone>& prior,
                    const ToldParts& told);

}  // namespace heft
