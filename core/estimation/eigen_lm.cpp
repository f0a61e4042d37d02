#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "core/base/say.h"
#include "core/estimation/physical_parameters.h"

namespace heft {

namespace {

/// Residual of the free parameters only, in the form that Eigen's solver asks for.
struct RowsFunctor {
  using Scalar = double;
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const SolverProblem* problem;
  std::array<double, kPhysicalParameters> start;
  std::vector<std::size_t> free;

  int inputs() const { return static_cast<int>(free.size()); }
  int values() const { return static_cast<int>(problem->A.rows()); }

  VectorXd linear(const VectorXd& z) const {
    auto theta = start;
    for (std::size_t i = 0; i < free.size(); ++i) theta[free[i]] = z(static_cast<Eigen::Index>(i));
    return linearFromPhysical(theta);
  }
  int operator()(const VectorXd& z, VectorXd& residual) const {
    residual.noalias() = problem->A * linear(z) - problem->y;
    return 0;
  }
};

std::string reasonOf(int status) {
  using namespace Eigen::LevenbergMarquardtSpace;
  switch (status) {
    case RelativeReductionTooSmall:
    case RelativeErrorTooSmall:
    case RelativeErrorAndReductionTooSmall:
      return heft::say("Converged: steps no longer change the result.");
    case CosinusTooSmall:
      return heft::say("Converged: the residual is orthogonal to every direction.");
    case TooManyFunctionEvaluation:
      return heft::say("Stopped after the largest number of evaluations.");
    case FtolTooSmall:
    case XtolTooSmall:
    case GtolTooSmall:
      return heft::say("Converged to rounding.");
    default:
      return heft::say("Stopped with improper input.");
  }
}

}  // namespace

SolverSolution solveEigenLm(const SolverProblem& problem) {
  RowsFunctor functor{&problem, physicalStart(problem), {}};
  for (std::size_t i = 0; i < kPhysicalParameters; ++i) {
    const bool isBias = i < 6, isCom = i >= 7 && i < 10, isInertia = i >= 10;
    if ((isBias && !problem.bias) || (isCom && problem.parameters == ParameterSet::mass) ||
        (isInertia && problem.parameters != ParameterSet::full))
      continue;
    functor.free.push_back(i);
  }
  VectorXd z(static_cast<Eigen::Index>(functor.free.size()));
  for (std::size_t i = 0; i < functor.free.size(); ++i)
    z(static_cast<Eigen::Index>(i)) = functor.start[functor.free[i]];
  Eigen::NumericalDiff<RowsFunctor> differentiated(functor);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<RowsFunctor>> solver(differentiated);
  solver.parameters.maxfev = 5000;
  solver.parameters.ftol = solver.parameters.xtol = 1e-13;
  const int status = solver.minimize(z);
  const VectorXd x = functor.linear(z);
  SolverSolution solution;
  solution.bias = x.head<6>();
  solution.phi = x.tail<10>();
  solution.iterations = static_cast<int>(solver.iter);
  solution.usable = x.allFinite() && status > 0 && status != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation;
  solution.why = reasonOf(status);
  return solution;
}

}  // namespace heft
