#pragma once
// Mass, centre of mass and inertia as the unknowns of nonlinear solvers.
#include <array>

#include "core/estimation/solvers.h"

namespace heft {

/// theta = [bias 6, m, cx, cy, cz, Ixx, Ixy, Ixz, Iyy, Iyz, Izz], inertia about S's origin: x = [bias, m, m c, I].
constexpr int kPhysicalParameters = 16;

template <class T>
std::array<T, kColumns> linearFromPhysical(const T* bias, const T* mass, const T* com, const T* inertia) {
  std::array<T, kColumns> x;
  for (std::size_t i = 0; i < 6; ++i) x[i] = bias[i];
  x[6] = mass[0];
  for (std::size_t i = 0; i < 3; ++i) x[7 + i] = mass[0] * com[i];
  for (std::size_t i = 0; i < 6; ++i) x[10 + i] = inertia[i];
  return x;
}

inline Eigen::Matrix<double, kColumns, 1> linearFromPhysical(const std::array<double, kPhysicalParameters>& theta) {
  const auto x = linearFromPhysical<double>(theta.data(), &theta[6], &theta[7], &theta[10]);
  return Eigen::Map<const Eigen::Matrix<double, kColumns, 1>>(x.data());
}

/// Where nonlinear solvers start: known values for what is not estimated; one kilogram at the sensor otherwise.
inline std::array<double, kPhysicalParameters> physicalStart(const SolverProblem& problem) {
  std::array<double, kPhysicalParameters> theta{};
  theta[6] = 1.0;
  if (problem.parameters != ParameterSet::full) {
    const Vector10d phi = toParameters(problem.known);
    for (std::size_t i = 0; i < 6; ++i) theta[10 + i] = phi(static_cast<Eigen::Index>(4 + i));
  }
  if (problem.parameters == ParameterSet::mass)
    for (std::size_t i = 0; i < 3; ++i) theta[7 + i] = problem.known.com(static_cast<Eigen::Index>(i));
  return theta;
}

}  // namespace heft
