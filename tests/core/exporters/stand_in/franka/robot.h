#pragma once
// Stand-in for libfranka's header of the same name: only what an exported file uses.
#include <array>

namespace franka {

struct Robot {
  void setLoad(double load_mass, const std::array<double, 3>& F_x_Cload, const std::array<double, 9>& load_inertia) {
    mass = load_mass;
    com = F_x_Cload;
    inertia = load_inertia;
  }
  double mass = 0.0;
  std::array<double, 3> com{};
  std::array<double, 9> inertia{};
};

}  // namespace franka
