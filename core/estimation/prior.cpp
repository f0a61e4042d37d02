#include "core/estimation/prior.h"

#include <algorithm>
#include <cmath>

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
  (void)options;
  (void)findings;
  const RoughFit fit = roughFit(whitened);
  return ChosenPrior{vaguePrior(fit.mass, fit.com), Vector10d::Zero(), false};
}

}  // namespace heft
