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
  const auto x = linearFromPhysical(theta);
  solution.bias = x.head<6>();
  solution.phi = x.tail<10>();
  return solution;
}

}  // namespace heft
