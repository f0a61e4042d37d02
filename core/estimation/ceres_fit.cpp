#include "core/estimation/ceres_fit.h"

#include <ceres/ceres.h>

#include "core/estimation/physical_parameters.h"

namespace heft {

namespace {

/// All rows at once: residual = A x(theta) - y.
class RowsResidual {
 public:
  explicit RowsResidual(const SolverProblem& problem) : problem_(problem) {}

  template <class T>
  bool operator()(const T* bias, const T* mass, const T* com, const T* inertia, T* residual) const {
    const auto x = linearFromPhysical(bias, mass, com, inertia);
    for (Eigen::Index r = 0; r < problem_.A.rows(); ++r) {
      T sum = T(-problem_.y(r));
      for (int c = 0; c < kColumns; ++c) sum += problem_.A(r, c) * x[static_cast<std::size_t>(c)];
      residual[r] = sum;
    }
    return true;
  }

 private:
  const SolverProblem& problem_;
};

}  // namespace

}  // namespace heft

void heft_fit_by_ceres(const heft::SolverProblem& problem, double* theta, heft::SolverSolution& solution) {
  using namespace heft;
  double* bias = theta;
  double* mass = bias + 6;
  double* com = mass + 1;
  double* inertia = com + 3;
  ceres::Problem solver;
  solver.AddResidualBlock(new ceres::AutoDiffCostFunction<RowsResidual, ceres::DYNAMIC, 6, 1, 3, 6>(
                              new RowsResidual(problem), static_cast<int>(problem.A.rows())),
                          nullptr, bias, mass, com, inertia);
  if (!problem.bias) solver.SetParameterBlockConstant(bias);
  if (problem.parameters == ParameterSet::mass) solver.SetParameterBlockConstant(com);
  if (problem.parameters != ParameterSet::full) solver.SetParameterBlockConstant(inertia);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-14;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &solver, &summary);
  solution.usable = summary.IsSolutionUsable() && summary.termination_type == ceres::CONVERGENCE;
  solution.iterations = static_cast<int>(summary.iterations.size());
  solution.why = summary.message;
}
