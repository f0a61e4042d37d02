#include "core/estimation/prior.h"

#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/math/linear_algebra.h"
#include "core/payload/shape_bound.h"
#include "core/payload/shape_prior.h"

namespace heft {

namespace {

/// A rough shape is a help where the motion says little, not a measurement: so many standard deviations away it is of
/// another tool or place, and a blend would be what neither of the two says. Shapes a tenth off are up to 3.8 away, 40
/// % off up to 20 (test_estimation_accuracy --gtest_filter=ShapeGivesWay*).
constexpr double kRoughGivesWay = 12.0;

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
  const VectorXd phi = leastSquares(A, y).x;
  const double mass = std::clamp(phi(0), 0.01, 100.0);
  Vector3d com = phi.segment<3>(1) / mass;
  if (com.norm() > 0.5) com *= 0.5 / com.norm();
  return {mass, com};
}

/// The most probable payload for the rows, the shape and what else is stated. The stated terms are linear about the
/// last solution until that stays where it is.
ShapeFit fitWithStated(const ShapePrior& shape, const MatrixXd& A, const VectorXd& y,
                       const std::vector<StatedTerm>& stated) {
  ShapeFit fit = shape.fit(A, y);
  const auto extra = 10 * static_cast<Eigen::Index>(stated.size());
  MatrixXd rows(A.rows() + extra, 10);
  VectorXd values(A.rows() + extra);
  rows.topRows(A.rows()) = A;
  values.head(A.rows()) = y;
  for (int round = 0; round < 20 && !stated.empty(); ++round) {
    Eigen::Index at = A.rows();
    for (const auto& term : stated) {
      const LinearTerm linear = linearised(term, fit.phi);
      rows.middleRows<10>(at) = linear.A;
      values.segment<10>(at) = linear.y;
      at += 10;
    }
    const Vector10d before = fit.phi;
    fit = shape.fit(rows, values);
    const Vector10d step = fit.phi - before;
    if (step.dot(solveSymmetric(fit.covariance, step)) < 1e-12) break;
  }
  return fit;
}

/// Nothing where the shape gives way to the motion.
Result<std::optional<ChosenPrior>> fromShape(const EstimateOptions& options, const Triangle& whitened,
                                             ChosenPrior chosen, Findings& findings, const ShapePrior* made) {
  std::optional<ShapePrior> own;
  if (!made || options.insideShape) {
    auto samples = sampleShape(*options.shape, findings);
    if (!samples) return samples.error();
    if (!made) made = &own.emplace(*options.shape, *samples);
    if (options.insideShape) chosen.bound = boundPoints(*options.shape, *samples);
  }
  const ShapePrior& shape = *made;
  const int first = options.bias ? kBiasColumns : 0;
  const ShapeFit fit = fitWithStated(shape, whitened.block(first, kBiasColumns, kColumns + 1 - first, 10),
                                     whitened.col(kColumns).tail(kColumns + 1 - first), chosen.prior.stated);
  // By how many standard deviations, of material, sizes and place together, the shape would have to be another one.
  const double away = std::sqrt(fit.conflict);
  // Who holds the mass inside the shape insists on it.
  if (options.shape->certainty == Certainty::rough && !options.insideShape && away > kRoughGivesWay) {
    findings.push_back({Severity::warning,
                        "shape_left_out",
                        heft::say("The shape contradicts the measured motion by {:.0f} standard deviations, so it was "
                                  "not used: the numbers come from the motion alone.",
                                  away),
                        heft::say("Check its size and position, or remove it."),
                        {}});
    return std::optional<ChosenPrior>();
  }
  if (!fit.converged)
    findings.push_back({Severity::warning,
                        "shape_not_converged",
                        heft::say("Could not find a material density that fits this shape."),
                        heft::say("Check the shape's size and position."),
                        {}});
  if (fit.conflict > 30.0)
    findings.push_back({Severity::warning,
                        "shape_contradicts_data",
                        heft::say("The shape does not match the measurement: a tool of that shape and position would "
                                  "have caused other forces."),
                        options.shape->certainty == Certainty::rough
                            ? heft::say("Check its size and position, or remove it.")
                            : heft::say("Check its size and position, or choose \"rough\"."),
                        {}});
  chosen.prior.U0 = fit.U0;
  chosen.prior.mean = fit.mean;
  chosen.prior.information = fit.information;
  const ShapeFit alone = fitWithStated(shape, MatrixXd(0, 10), VectorXd(0), chosen.prior.stated);
  chosen.alone = PriorAlone{alone.phi, alone.covariance};
  chosen.told.com = chosen.told.inertia = true;
  chosen.told.mass = chosen.told.mass || options.shape->totalMass ||
                     std::all_of(options.shape->bodies.begin(), options.shape->bodies.end(),
                                 [](const ShapeBody& body) { return body.mass || body.density; });
  return std::optional(std::move(chosen));
}

}  // namespace

Result<ChosenPrior> priorFor(const EstimateOptions& options, const Triangle& whitened, Findings& findings,
                             const ShapePrior* made) {
  ChosenPrior chosen;
  for (const auto& stated : options.stated) {
    chosen.prior.stated.push_back(termFrom(stated));
    chosen.told.mass = chosen.told.mass || stated.mass;
    chosen.told.com = chosen.told.com || stated.com;
    chosen.told.inertia = chosen.told.inertia || stated.spread;
  }
  if (options.shape) {
    auto shaped = fromShape(options, whitened, chosen, findings, made);
    if (!shaped) return shaped.error();
    if (*shaped) return std::move(**shaped);
  }

  // What nobody told is vague about a rough fit; what somebody told, vague about that, so that it pulls at nothing.
  RoughFit fit = roughFit(whitened);
  Matrix3d spread = kUsualRadius * kUsualRadius * Matrix3d::Identity();
  for (const auto& stated : options.stated) {
    fit.mass = stated.mass.value_or(fit.mass);
    fit.com = stated.com.value_or(fit.com);
    spread = stated.spread.value_or(spread);
  }
  MapPrior vague = vaguePrior(fit.mass, fit.com, spread);
  vague.stated = std::move(chosen.prior.stated);
  chosen.prior = std::move(vague);
  if (chosen.told.any()) {
    const MapSolution alone = solveMap(Triangle::Zero(), chosen.prior, options.bias, chosen.start);
    const Matrix10d J = parametersJacobian(chosen.prior, alone.v);
    chosen.alone = PriorAlone{alone.phi, J * alone.covariance * J.transpose()};
  }
  return chosen;
}

}  // namespace heft
