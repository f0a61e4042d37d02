#include "core/estimation/prior.h"

#include <algorithm>
#include <cmath>

#include "core/payload/shape_prior.h"

namespace heft {

namespace {

/// Mass and centre of mass of a linear fit, held to what a hand can carry where the data say little.
struct RoughFit {
  double mass;
  Vector3d com;
};

RoughFit roughFit(const Triangle& R) {
  // One kilogram within a factor of a few, centre of mass at the sensor within a quarter of a metre.
  MatrixXd A(11 + 10, 10);
  VectorXd y = VectorXd::Zero(21);
  A.topRows<11>() = R.block<11, 10>(kBiasColumns, kBiasColumns);
  y.head<11>() = R.block<11, 1>(kBiasColumns, kColumns);
  VectorXd sd(10);
  sd << 3.0, 0.25, 0.25, 0.25, VectorXd::Constant(6, 0.1);
  A.bottomRows<10>() = sd.cwiseInverse().asDiagonal();
  y(11) = 1.0 / sd(0);
  const VectorXd phi = A.colPivHouseholderQr().solve(y);
  const double mass = std::clamp(phi(0), 0.01, 100.0);
  Vector3d com = phi.segment<3>(1) / mass;
  if (com.norm() > 0.5) com *= 0.5 / com.norm();
  return {mass, com};
}

}  // namespace

Result<ChosenPrior> priorFor(const EstimateOptions& options, const Triangle& whitened, Findings& findings) {
  if (!options.shape) {
    const RoughFit fit = roughFit(whitened);
    return ChosenPrior{vaguePrior(fit.mass, fit.com), Vector10d::Zero(), false};
  }
  auto samples = sampleShape(*options.shape, findings);
  if (!samples) return samples.error();
  const int first = options.bias ? kBiasColumns : 0;
  const ShapeFit fit = ShapePrior(*options.shape, *samples)
                           .fit(whitened.block(first, kBiasColumns, kColumns + 1 - first, 10),
                                whitened.col(kColumns).tail(kColumns + 1 - first));
  if (!fit.converged)
    findings.push_back({Severity::warning,
                        "shape_not_converged",
                        "The search for the shape's material did not settle.",
                        "Check the shape's size and place.",
                        {}});
  if (fit.conflict > 30.0)
    findings.push_back(
        {Severity::warning,
         "shape_contradicts_data",
         "The shape and the measured motion contradict each other: a tool of that shape and place would have moved "
         "the sensor differently.",
         "Check the shape's size and where it sits, or choose \"rough\".",
         {}});
  return ChosenPrior{{fit.U0, fit.mean, fit.information}, Vector10d::Zero(), true};
}

}  // namespace heft
