#include "core/base/library_on_demand.h"
#include "core/estimation/ceres_fit.h"
#include "core/estimation/physical_parameters.h"

namespace heft {

namespace {

const LibraryOnDemand ceresLibrary{HEFT_CERES_LIBRARY, ""};
const FunctionOnDemand<decltype(::heft_fit_by_ceres)> fitByCeres{ceresLibrary, "heft_fit_by_ceres"};

}  // namespace

SolverSolution solveCeres(const SolverProblem& problem) {
  SolverSolution solution;
  solution.why = ceresLibrary.problem();
  if (!solution.why.empty()) return solution;
  auto theta = physicalStart(problem);
  fitByCeres(problem, theta.data(), solution);
  const double* bias = theta.data();
  const double* mass = bias + 6;
  const double* com = mass + 1;
  const auto x = linearFromPhysical<double>(bias, mass, com, com + 3);
  for (int i = 0; i < 6; ++i) solution.bias(i) = x[static_cast<std::size_t>(i)];
  for (int i = 0; i < 10; ++i) solution.phi(i) = x[6 + static_cast<std::size_t>(i)];
  return solution;
}

}  // namespace heft
