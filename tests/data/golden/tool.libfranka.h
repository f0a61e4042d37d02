#pragma once
// Heft 0.0, recording demo.csv -- method map
// 95 %: mass 0.7521 to 0.7547 kg; centre of mass +-0.4 mm; inertia +-7 %
// This is a load. A tool that Desk already knows as end effector would be counted twice.
#include <franka/robot.h>

#include <array>

inline void setPayload(franka::Robot& robot) {
  const double load_mass = 0.753422;  // [kg]
  const std::array<double, 3> F_x_Cload{{0.012346, -0.0045, 0.067891}};  // flange to centre of mass, flange axes [m]
  // About the centre of mass, flange axes, column-major [kg m2]
  const std::array<double, 9> load_inertia{{0.00299491, 0.0001477, 0.00010562, 0.0001477, 0.00259193, 0.00056217, 0.00010562, 0.00056217, 0.00131316}};
  robot.setLoad(load_mass, F_x_Cload, load_inertia);
}
