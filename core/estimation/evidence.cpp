#include "core/estimation/evidence.h"

#include <cmath>
#include <limits>

#include "core/estimation/prior.h"
#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// Standard deviations above these tell nothing about anything that a hand can guide.
constexpr double kUselessMass = 50.0, kUselessCom = 1.0, kUselessInertia = 10.0;  // [kg], [m], [kg m2]

/// Inverse of A^T A; what no row tells gets a variance far above everything useful.
Matrix10d covarianceOf(const MatrixXd& A) {
  const Vector10d scale = A.colwise().norm().transpose().cwiseMax(1e-9).cwiseInverse();
  const MatrixXd scaled = A * scale.asDiagonal();
  const auto [values, vectors] = symmetricEigen(transposedProduct(scaled, scaled));
  const VectorXd inverse = values.cwiseMax(1e-13).cwiseInverse();
  return congruence(scale.asDiagonal() * vectors, inverse.asDiagonal().toDenseMatrix());
}

Vector10d componentStd(const Vector10d& phi, const Matrix10d& covariance) {
  const Matrix10d J = componentsJacobian(phi);
  return congruence(J, covariance).diagonal().cwiseMax(0.0).cwiseSqrt();
}

/// NaN for what is too uncertain to be called known at all.
void dropUseless(Vector10d& values, Vector10d& std) {
  const auto drop = [&](int i) { values(i) = std(i) = kUnknown; };
  const bool mass = std(0) < kUselessMass && values(0) > 3.0 * std(0);
  if (!(std(0) < kUselessMass)) drop(0);
  for (int i = 1; i < 10; ++i)
    if (!mass || !(std(i) < (i < 4 ? kUselessCom : kUselessInertia))) drop(i);
}

}  // namespace

Evidence::Evidence() {
  for (Vector10d* v : {&data, &dataStd, &best, &prior, &priorStd, &shift, &disagreement}) v->setConstant(kUnknown);
}

Evidence evidenceOf(const Triangle& R, bool bias, const Vector10d& result, const std::optional<PriorAlone>& prior,
                    const ToldParts& told) {
  Evidence out;
  const int first = bias ? kBiasColumns : 0;
  const MatrixXd A = R.block(first, kBiasColumns, kColumns + 1 - first, 10);
  const VectorXd y = R.col(kColumns).tail(kColumns + 1 - first);
  const Matrix10d covariance = covarianceOf(A);
  const Vector10d phi = shortestLeastSquares(A, y);
  const Vector10d value = componentsOf(fromParameters(result));
  out.best = componentStd(result, covariance);
  Vector10d unused = value;
  dropUseless(unused, out.best);
  out.data = componentsOf(fromParameters(phi));
  out.dataStd = componentStd(phi, covariance);
  dropUseless(out.data, out.dataStd);
  if (!prior) return out;

  out.hasPrior = true;
  const Vector10d said = componentsOf(fromParameters(prior->phi)),
                  saidStd = componentStd(prior->phi, prior->covariance);
  for (int i = 0; i < 10; ++i) {
    if (i == 0 ? !told.mass : i < 4 ? !told.com : !(told.inertia && told.mass)) continue;
    out.prior(i) = said(i);
    out.priorStd(i) = saidStd(i);
  }
  out.shift = (value - out.data).cwiseQuotient(out.dataStd);
  out.disagreement =
      (out.prior - out.data).cwiseQuotient((out.priorStd.cwiseAbs2() + out.dataStd.cwiseAbs2()).cwiseSqrt());
  return out;
}

}  // namespace heft
