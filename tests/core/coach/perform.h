#pragma once
// An arm with a tool and a sensor that makes proposed motions, as a robot or a docile hand would.
#include <cmath>

#include <gtest/gtest.h>

#include "core/coach/coach.h"
#include "core/simulation/sensor.h"
#include "core/wrench/regressor.h"
#include "tests/core/online/feed.h"

namespace heft::test {

class Performer {
 public:
  Performer(const Payload& payload, unsigned seed) : payload_(payload), seed_(seed) {
    bias_ = drawBias(options_.sensor, seed);
  }

  const SensorMount& mount() const { return options_.mount; }
  const Vector3d& gravity() const { return options_.gravity; }

  /// The motion as the recording that a 1 kHz sensor would make of it, from `start` [s] on.
  Recording perform(const JointMotion& motion, double start) {
    const RobotModel& panda = RobotModel::panda();
    const GuidedTool tool = *guidedTool(panda, options_.mount);
    Recording out;
    out.meta.robot = "panda";
    out.meta.mount = options_.mount;
    const auto n = static_cast<Eigen::Index>(std::lround(motion.duration() * 1000.0));
    out.time.resize(n);
    out.q.resize(n, 7);
    out.dq.resize(n, 7);
    out.wrench.resize(n, 6);
    VectorXd q, dq, ddq;
    for (Eigen::Index k = 0; k < n; ++k) {
      out.time(k) = start + 0.001 * static_cast<double>(k);
      motion.at(0.001 * static_cast<double>(k), q, dq, ddq);
      out.q.row(k) = q.transpose();
      out.dq.row(k) = dq.transpose();
      const FrameMotion m = panda.frameMotion(tool.link, tool.X_LS, q, dq, ddq);
      const Matrix3d R = m.X_BS.linear().transpose();
      out.wrench.row(k) =
          predictWrench(payload_, {R * (m.a_BSo_B - options_.gravity), R * m.w_BS_B, R * m.alpha_BS_B}).transpose();
    }
    options_.seed = seed_++;
    measureWrench(options_.sensor, options_.seed, 1000.0, bias_, out.wrench);
    measureJoints(options_, out.q, out.dq);
    return out;
  }

  /// Standing still at `q` for `seconds`.
  static JointMotion hold(const VectorXd& q, double seconds) {
    JointMotion motion;
    motion.time = VectorXd::LinSpaced(3, 0.0, seconds);
    motion.q = q.transpose().replicate(3, 1);
    motion.dq = motion.ddq = MatrixXd::Zero(3, q.size());
    return motion;
  }

 private:
  Payload payload_;
  unsigned seed_;
  SimulateOptions options_;
  Vector6d bias_;
};

/// A demonstration that tells little: one slow tilt by a few degrees.
inline JointMotion dullMotion() {
  const RobotModel& panda = RobotModel::panda();
  const Eigen::Index n = 201;
  JointMotion motion;
  motion.time = VectorXd::LinSpaced(n, 0.0, 4.0);
  motion.q = panda.homePosture().transpose().replicate(n, 1);
  motion.dq = motion.ddq = MatrixXd::Zero(n, 7);
  constexpr double kOmega = 2.0 * 3.14159265358979 / 4.0;
  for (Eigen::Index k = 0; k < n; ++k)
    for (const int j : {4, 5, 6}) {
      const double a = 0.05, t = kOmega * motion.time(k) * (j - 3);
      motion.q(k, j) += a * (1.0 - std::cos(t));
      motion.dq(k, j) = a * (j - 3) * kOmega * std::sin(t);
      motion.ddq(k, j) = a * (j - 3) * (j - 3) * kOmega * kOmega * std::cos(t);
    }
  return motion;
}

/// Standard deviation of what is asked for [kg, m], relative for the inertia: the largest of its parts.
inline double width(const OnlineState& state, CoachGoal quantity) {
  switch (quantity) {
    case CoachGoal::mass:
      return state.std.mass;
    case CoachGoal::com:
      return state.std.com.maxCoeff();
    case CoachGoal::inertia:
      return state.std.inertiaCom.diagonal().cwiseQuotient(state.payload.inertiaCom.diagonal()).maxCoeff();
  }
  return 0.0;
}

/// Every limit at 1 kHz, from positions alone where that is possible: nothing of what limitUse() does.
inline void expectLimitsKept(const JointMotion& motion, const GuidedTool& tool, double tcpSpeed) {
  const RobotModel& robot = *tool.robot;
  VectorXd q, dq, ddq;
  Vector3d before;
  const auto n = static_cast<int>(motion.duration() * 1000.0);
  double speed = 0.0;
  for (int k = 0; k <= n; ++k) {
    motion.at(0.001 * k, q, dq, ddq);
    for (int j = 0; j < robot.dof(); ++j) {
      const JointLimits& limits = robot.limits(j);
      ASSERT_GE(q(j), limits.lower) << k;
      ASSERT_LE(q(j), limits.upper) << k;
      ASSERT_LE(std::abs(dq(j)), limits.velocity) << k;
      ASSERT_LE(std::abs(ddq(j)), limits.acceleration) << k;
    }
    const Vector3d p = (robot.linkPose(q, tool.link) * tool.X_LS).translation();
    if (k > 0) speed = std::max(speed, (p - before).norm() / 0.001);
    before = p;
  }
  EXPECT_LE(speed, 1.01 * tcpSpeed);
}

}  // namespace heft::test
