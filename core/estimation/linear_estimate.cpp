#include "core/estimation/linear_estimate.h"

#include <algorithm>

#include "core/estimation/triangle.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

SolverSolution runSolver(Method method, const SolverProblem& problem, const ColumnNoise& noise) {
  switch (method) {
    case Method::tls:
      return solveScaledTls(problem, noise);
    case Method::tlsFast:
    case Method::tlsExact:
      return solveTls(problem);
    case Method::ceres:
      return solveCeres(problem);
    case Method::eigenLm:
      return solveEigenLm(problem);
    case Method::bruteForce:
      return solveBruteForce(problem);
    case Method::map:
    case Method::ls:
    case Method::wls:
      return solveLeastSquares(problem);
  }
  return {};
}

/// Of a symmetric positive semidefinite matrix with very unequal units.
MatrixXd scaledPseudoInverse(const MatrixXd& H) {
  const VectorXd scale = H.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  return scale.asDiagonal() * pseudoInverse(scale.asDiagonal() * H * scale.asDiagonal()) * scale.asDiagonal();
}

}  // namespace

AllRows collectRows(const Prepared& prepared, const Vector6d& weights, bool keepRows) {
  const WrenchRows samples = rowsOf(prepared.sampled(), 0.0);
  const int perBlock = prepared.blocks.samplesPerBlock;
  std::vector<TriangleBuilder> builders(kFolds);
  AllRows out;
  if (keepRows) out.rows.resize(6 * prepared.usedBlocks * perBlock, kColumns + 1);
  for (const auto& run : prepared.runs) {
    for (Eigen::Index block = run.from; block < run.to; ++block) {
      auto& builder = builders[static_cast<std::size_t>(prepared.foldOf(block))];
      for (Eigen::Index k = block * perBlock; k < (block + 1) * perBlock; ++k) {
        const Eigen::Matrix<double, 6, kColumns + 1> six = weights.asDiagonal() * blockRows(samples, k);
        if (keepRows) {
          out.rows.middleRows<6>(out.count) = six;
        } else {
          builder.add(six);
        }
        out.count += 6;
      }
    }
  }
  if (!keepRows)
    for (auto& builder : builders) out.folds.push_back(builder.finish());
  return out;
}

ColumnNoise columnNoise(const WrenchRows& blocks, const Vector6d& weights) {
  ColumnNoise sum = ColumnNoise::Zero();
  double count = 0.0;
  for (Eigen::Index k = 1; k + 1 < blocks.size(); ++k) {
    const auto at = [&](Eigen::Index j) { return static_cast<std::size_t>(j); };
    const Regressor second = blocks.Y[at(k - 1)] - 2.0 * blocks.Y[at(k)] + blocks.Y[at(k + 1)];
    const Vector6d wrench = blocks.wrench.col(k - 1) - 2.0 * blocks.wrench.col(k) + blocks.wrench.col(k + 1);
    sum.head<10>() += (weights.asDiagonal() * second).colwise().squaredNorm().transpose();
    sum(10) += weights.cwiseProduct(wrench).squaredNorm();
    count += 36.0;
  }
  return (sum / std::max(1.0, count)).cwiseSqrt();
}

SolverSolution solveWithKnown(Method method, const Triangle* triangle, const Rows* rows, const EstimateOptions& options,
                              const Payload& known, const ColumnNoise& noise) {
  SolverProblem problem = triangle ? problemFrom(*triangle, options.parameters, options.bias, known)
                                   : SolverProblem{rows->leftCols<kColumns>(), rows->col(kColumns), options.parameters,
                                                   options.bias, known};
  SolverSolution solution = runSolver(method, problem, noise);
  if (options.parameters != ParameterSet::massCom) return solution;
  for (int round = 0; round < 5 && solution.usable && solution.phi(0) > 0.0; ++round) {
    problem.known.mass = solution.phi(0);
    problem.known.com = solution.phi.segment<3>(1) / solution.phi(0);
    const Vector10d before = solution.phi;
    solution = runSolver(method, problem, noise);
    if ((solution.phi - before).head<4>().norm() < 1e-10 * before.head<4>().norm()) break;
  }
  return solution;
}

Matrix10d covarianceOf(const Triangle& whitened, const EstimateOptions& options, const Payload& known) {
  const MatrixXd map = selectionFor(options.parameters, options.bias, known).map;
  const MatrixXd A = product(whitened.leftCols<kColumns>(), map);
  return congruence(map, scaledPseudoInverse(transposedProduct(A, A))).bottomRightCorner<10, 10>();
}

Matrix10d sandwich(const Prepared& prepared, const EstimateOptions& options, const Payload& known,
                   const Vector6d& weights) {
  const auto [map, offset] = selectionFor(options.parameters, options.bias, known);
  Eigen::Matrix<double, kColumns, kColumns> bread = Eigen::Matrix<double, kColumns, kColumns>::Zero();
  const Vector6d W = weights.cwiseAbs2();
  for (const auto& run : prepared.runs)
    for (Eigen::Index k = run.from; k < run.to; ++k) {
      const Eigen::Matrix<double, 6, kColumns> A = blockRows(prepared.blocks, k).leftCols<kColumns>();
      bread += transposedProduct(A, W.asDiagonal() * A);
    }
  const MatrixXd back = map.transpose();
  const MatrixXd inverse = product(map, scaledPseudoInverse(congruence(back, bread)));
  const MatrixXd meat = congruence(back, scoreCovariance(prepared.blocks, prepared.noise, W, prepared.runs));
  return congruence(inverse, meat).bottomRightCorner<10, 10>();
}

}  // namespace heft
