#pragma once
// The paper's estimators on a prepared recording: which rows they see, what is held known, and how uncertain they are.
#include <vector>

#include "core/estimation/map.h"
#include "core/estimation/prepare.h"
#include "core/estimation/solvers.h"

namespace heft {

/// Noise of the ten regressor columns and of the wrench.
using ColumnNoise = Eigen::Matrix<double, 11, 1>;

/// Rows for the paper's estimators: every sample of the motion inside the used blocks, each channel times its weight.
struct AllRows {
  std::vector<Triangle> folds;
  Rows rows;  ///< Only filled when the solver runs uncompressed.
  Eigen::Index count = 0;
};
AllRows collectRows(const Prepared& prepared, const Vector6d& weights, bool keepRows);

/// From steps between neighbouring blocks: what the motion and the sensor change between two blocks bounds their noise
/// from above.
ColumnNoise columnNoise(const WrenchRows& blocks, const Vector6d& weights);

/// Solves (map: the linear least squares of whitened rows), and where the known inertia is about the centre of mass
/// that is itself being estimated, repeats with the inertia moved to it: the shift is of second order, so a few rounds
/// settle it. One of `triangle` and `rows` is given.
SolverSolution solveWithKnown(Method method, const Triangle* triangle, const Rows* rows, const EstimateOptions& options,
                              const Payload& known, const ColumnNoise& noise);

/// Covariance of phi for the least squares of whitened rows.
Matrix10d covarianceOf(const Triangle& whitened, const EstimateOptions& options, const Payload& known);

/// Covariance of phi for a linear estimator with row weights, noise coloured as found.
Matrix10d sandwich(const Prepared& prepared, const EstimateOptions& options, const Payload& known,
                   const Vector6d& weights);

}  // namespace heft
