#pragma once
// Smooth motions through random postures.
#include <algorithm>
#include <random>

#include "core/robot/joint_motion.h"
#include "core/robot/robot_model.h"

namespace heft::test {

/// Rests at each of `stops` random postures, `step` seconds apart.
inline JointMotion randomMotion(const RobotModel& robot, unsigned seed, int stops, double step) {
  std::mt19937 random(seed);
  JointMotion motion;
  motion.time.resize(stops);
  motion.q = motion.dq = motion.ddq = MatrixXd::Zero(stops, robot.dof());
  for (Eigen::Index k = 0; k < stops; ++k) {
    motion.time(k) = step * static_cast<double>(k);
    for (int j = 0; j < robot.dof(); ++j) {
      const JointLimits& limits = robot.limits(j);
      motion.q(k, j) = std::uniform_real_distribution<double>(limits.lower, limits.upper)(random);
    }
  }
  return motion;
}

}  // namespace heft::test
