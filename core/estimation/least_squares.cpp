#include <cmath>

#include "core/base/say.h"
#include "core/estimation/solvers.h"

namespace heft {

SolverProblem problemFrom(const Triangle& R, ParameterSet parameters, bool bias, const Payload& known) {
  return {R.leftCols<kColumns>(), R.col(kColumns), parameters, bias, known};
}

Selection selectionFor(ParameterSet parameters, bool bias, const Payload& known) {
  const int biases = bias ? kBiasColumns : 0;
  const int free = parameters == ParameterSet::full ? 10 : parameters == ParameterSet::massCom ? 4 : 1;
  Selection selection{MatrixXd::Zero(kColumns, biases + free), VectorXd::Zero(kColumns)};
  if (bias) selection.map.topLeftCorner(kBiasColumns, kBiasColumns).setIdentity();
  if (parameters != ParameterSet::full) selection.offset.tail<6>() = toParameters(known).tail<6>();
  if (parameters == ParameterSet::mass) {
    selection.map(kBiasColumns, biases) = 1.0;
    selection.map.block<3, 1>(kBiasColumns + 1, biases) = known.com;
  } else {
    selection.map.block(kBiasColumns, biases, free, free).setIdentity();
  }
  return selection;
}

namespace {

SolverSolution fromFull(const VectorXd& x, int iterations, bool usable, std::string why) {
  SolverSolution solution;
  solution.bias = x.head<kBiasColumns>();
  solution.phi = x.tail<10>();
  solution.iterations = iterations;
  solution.usable = usable && x.allFinite();
  solution.why = std::move(why);
  return solution;
}

}  // namespace

SolverSolution solveLeastSquares(const SolverProblem& problem) {
  const auto [map, offset] = selectionFor(problem.parameters, problem.bias, problem.known);
  const auto [z, fullRank] = leastSquares(product(problem.A, map), problem.y - problem.A * offset);
  return fromFull(offset + map * z, 1, fullRank,
                  fullRank ? heft::say("Solved in one step.")
                           : heft::say("This motion leaves some parameters without any information."));
}

SolverSolution solveTls(const SolverProblem& problem) {
  const auto [map, offset] = selectionFor(problem.parameters, problem.bias, problem.known);
  const Eigen::Index d = map.cols();
  MatrixXd augmented(problem.A.rows(), d + 1);
  augmented.leftCols(d) = product(problem.A, map);
  augmented.col(d) = problem.y - problem.A * offset;
  // The right singular vector of the smallest singular value is the direction that [A | y] knows least about.
  const VectorXd v = thinSvd(augmented).V.col(d);
  if (std::abs(v(d)) < 1e-12)
    return fromFull(
        offset, 1, false,
        heft::say("Total least squares has no solution here: the smallest singular value belongs to the regressor."));
  const VectorXd z = -v.head(d) / v(d);
  return fromFull(offset + map * z, 1, true, heft::say("Singular value decomposition done."));
}

SolverSolution solveScaledTls(const SolverProblem& problem, const Eigen::Matrix<double, 11, 1>& columnNoise) {
  const auto [map, offset] = selectionFor(problem.parameters, problem.bias, problem.known);
  const Eigen::Index d = map.cols();
  const Eigen::Index exact = problem.bias ? kBiasColumns : 0;
  MatrixXd augmented(problem.A.rows(), d + 1);
  augmented.leftCols(d) = product(problem.A, map);
  augmented.col(d) = problem.y - problem.A * offset;
  const MatrixXd R = upperTriangle(augmented);
  const Eigen::Index noisy = d - exact;
  VectorXd scale(noisy + 1);
  const MatrixXd phiMap = map.bottomRightCorner(10, noisy);
  for (Eigen::Index i = 0; i < noisy; ++i) scale(i) = (phiMap.col(i).cwiseProduct(columnNoise.head<10>())).norm();
  scale(noisy) = columnNoise(10);
  scale = scale.cwiseMax(1e-9 * scale.maxCoeff());
  const MatrixXd block = R.bottomRightCorner(noisy + 1, noisy + 1) * scale.cwiseInverse().asDiagonal();
  const VectorXd v = thinSvd(block).V.col(noisy);
  if (std::abs(v(noisy)) < 1e-12)
    return fromFull(
        offset, 1, false,
        heft::say("Total least squares has no solution here: the smallest singular value belongs to the regressor."));
  VectorXd z(d);
  z.tail(noisy) = (-v.head(noisy) / v(noisy) * scale(noisy)).cwiseQuotient(scale.head(noisy));
  z.head(exact) =
      solveUpper(R.topLeftCorner(exact, exact), R.col(d).head(exact) - R.block(0, exact, exact, noisy) * z.tail(noisy));
  return fromFull(offset + map * z, 1, true, heft::say("Singular value decomposition done."));
}

}  // namespace heft
