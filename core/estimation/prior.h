#pragma once
// The prior that an estimate runs with: from the user's shape and values, or the vague one.
#include "core/base/result.h"
#include "core/estimation/map.h"
#include "core/estimation/options.h"

namespace heft {

/// Which parts the user said something about.
struct ToldParts {
  bool mass = false, com = false, inertia = false;
  bool any() const { return mass || com || inertia; }
};

/// What the user's shape and values say without any data; the parts that nobody told are as vague as can be.
struct PriorAlone {
  Vector10d phi = Vector10d::Zero();
  Matrix10d covariance = Matrix10d::Zero();  ///< Of phi, linear about it.
};

struct ChosenPrior {
  MapPrior prior;
  Vector10d start = Vector10d::Zero();  ///< Where the solver begins.
  ToldParts told;
  std::optional<PriorAlone> alone;  ///< If anything was told, and not left out as contradicting the motion.
  Eigen::Matrix3Xd bound;           ///< Points that bound the shape, if the mass is to be held inside it.
};

class ShapePrior;

/// Fails where the shape itself cannot be used (a broken mesh file). `made` is the prior of the options' shape if it
/// has been made before, which saves sampling it again.
Result<ChosenPrior> priorFor(const EstimateOptions& options, const Triangle& whitened, Findings& findings,
                             const ShapePrior* made = nullptr);

}  // namespace heft
