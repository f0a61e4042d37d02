#pragma once
// The seed paper's estimators (and their relatives) on one problem: x = [bias, phi], rows [A | y].
#include <string>

#include "core/estimation/linear_problem.h"
#include "core/estimation/options.h"
#include "core/math/linear_algebra.h"

namespace heft {

/// What is estimated and what is known. Known values are used for the parameters that are not estimated; the inertia is
/// held about S's ORIGIN, as in the seed paper.
struct SolverProblem {
  MatrixXd A;  ///< n x 16: a triangle (n = 17) or all rows
  VectorXd y;
  ParameterSet parameters = ParameterSet::full;
  bool bias = true;
  Payload known;  ///< Values of what is not estimated, and where brute force looks and nonlinear solvers start
};

struct SolverSolution {
  Vector10d phi = Vector10d::Zero();
  Vector6d bias = Vector6d::Zero();
  bool usable = false;
  int iterations = 0;
  std::string why;  ///< Why it stopped, one sentence.
};

SolverProblem problemFrom(const Triangle& R, ParameterSet parameters, bool bias, const Payload& known);

/// x = offset + map z for the parameters that are estimated.
struct Selection {
  MatrixXd map;
  VectorXd offset;
};
Selection selectionFor(ParameterSet parameters, bool bias, const Payload& known);

/// Column-pivoted Householder QR: least squares of the rows as they are weighted.
SolverSolution solveLeastSquares(const SolverProblem& problem);

/// Total least squares of [A | y], every column with the same error (seed paper; Kubus 2008). The paper tells a fast
/// decomposition from an exact one; on a triangle of 17 rows the exact one is as fast, and serves both.
SolverSolution solveTls(const SolverProblem& problem);
/// Total least squares with columns scaled by their own noise; columns without noise (the biases) are exact and
/// eliminated first. `columnNoise`: 10 for phi's columns, then 1 for y.
SolverSolution solveScaledTls(const SolverProblem& problem, const Eigen::Matrix<double, 11, 1>& columnNoise);

/// Levenberg-Marquardt on mass, centre of mass and inertia about S (nonlinear through h = m c).
SolverSolution solveCeres(const SolverProblem& problem);    ///< Ceres, automatic differentiation
SolverSolution solveEigenLm(const SolverProblem& problem);  ///< Eigen, numerical differentiation

/// Searches a region around the known values: grids that shrink for up to four unknowns, samples that shrink towards
/// the best twentieth for ten. Biases are eliminated.
SolverSolution solveBruteForce(const SolverProblem& problem);

}  // namespace heft
