#pragma once
// The fit by Ceres, in a shared library of its own that is loaded at its first use: what Ceres brings (SuiteSparse,
// LAPACK, glog, TBB) took a third of the time in which a program started.
#include "core/estimation/solvers.h"

extern "C" {
/// \param theta kPhysicalParameters values (core/estimation/physical_parameters.h): from where, and what was found.
/// \param solution gets all but phi and bias.
void heft_fit_by_ceres(const heft::SolverProblem& problem, double* theta, heft::SolverSolution& solution);
}
