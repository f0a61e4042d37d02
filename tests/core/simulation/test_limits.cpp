// Every motion stays inside every limit, is brisk enough, and its derivatives belong together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/simulation/sample.h"

namespace heft {
namespace {

struct Extremes {
  double position = -1e9;                                          ///< how far beyond a position limit [rad]
  double velocity = 0.0, acceleration = 0.0;                       ///< as a share of the limit
  double speed = 0.0, turning = 0.0, linear = 0.0, angular = 0.0;  ///< Cartesian, SI
  double meanJointPeak = 0.0;                                      ///< [rad/s]
};

Extremes extremesOf(const Simulated& simulated, const SimulateOptions& options) {
  const RobotModel& robot = RobotModel::panda();
  Extremes e;
  for (int j = 0; j < robot.dof(); ++j) {
    const JointLimits& limits = robot.limits(j);
    e.position = std::max(
        {e.position, simulated.q.col(j).maxCoeff() - limits.upper, limits.lower - simulated.q.col(j).minCoeff()});
    const double peak = simulated.dq.col(j).cwiseAbs().maxCoeff();
    e.velocity = std::max(e.velocity, peak / limits.velocity);
    e.meanJointPeak += peak / robot.dof();
    e.acceleration = std::max(e.acceleration, simulated.ddq.col(j).cwiseAbs().maxCoeff() / limits.acceleration);
  }
  const int link = robot.findLink(options.mount.parent).value();
  const Isometry3d X_LS = poseFromXyzRpy(options.mount.xyz, options.mount.rpy);
  for (Eigen::Index k = 0; k < simulated.q.rows(); ++k) {
    const VectorXd q = simulated.q.row(k), dq = simulated.dq.row(k), ddq = simulated.ddq.row(k);
    for (const Isometry3d& X : {Isometry3d(Isometry3d::Identity()), X_LS}) {
      const FrameMotion m = robot.frameMotion(link, X, q, dq, ddq);
      e.speed = std::max(e.speed, m.v_BSo_B.norm());
      e.turning = std::max(e.turning, m.w_BS_B.norm());
      e.linear = std::max(e.linear, m.a_BSo_B.norm());
      e.angular = std::max(e.angular, m.alpha_BS_B.norm());
    }
  }
  return e;
}

void expectInside(const Extremes& e) {
  EXPECT_LT(e.position, 0.0);
  EXPECT_LT(e.velocity, 1.0);
  EXPECT_LT(e.acceleration, 1.0);
  EXPECT_LT(e.speed, 1.7);
  EXPECT_LT(e.turning, 2.5);
  EXPECT_LT(e.linear, 13.0);
  EXPECT_LT(e.angular, 25.0);
}

TEST(SimulationLimits, HoldForFiftySeedsOfEachMotion) {
  for (const MotionKind kind : kKinds) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      SCOPED_TRACE(testing::Message() << toString(kind) << " seed " << seed);
      SimulateOptions options = optionsFor(kind, seed);
      options.rateHz = 200.0;
      const auto simulated = simulate(RobotModel::panda(), sampleTool(), options);
      ASSERT_TRUE(simulated.ok()) << simulated.error().message;
      expectInside(extremesOf(*simulated, options));
    }
  }
}

TEST(SimulationLimits, HoldHoweverFastTheUserWantsIt) {
  for (const MotionKind kind : kKinds) {
    for (const double duration : {1.0, 6.0}) {
      SCOPED_TRACE(testing::Message() << toString(kind) << ", " << duration << " s");
      SimulateOptions options = optionsFor(kind, 5, duration);
      options.speed = 1000.0;
      const auto simulated = simulate(RobotModel::panda(), sampleTool(), options);
      ASSERT_TRUE(simulated.ok()) << simulated.error().message;
      expectInside(extremesOf(*simulated, options));
    }
  }
}

TEST(SimulationLimits, SpeedScalesTheJointPeaks) {
  for (const MotionKind kind : {MotionKind::excitation, MotionKind::free}) {
    for (const double speed : {1.0, 0.3}) {
      double mean = 0.0;
      constexpr int kSeeds = 8;
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        SimulateOptions options = optionsFor(kind, seed);
        options.rateHz = 100.0;
        options.speed = speed;
        const auto simulated = simulate(RobotModel::panda(), sampleTool(), options);
        ASSERT_TRUE(simulated.ok()) << simulated.error().message;
        mean += extremesOf(*simulated, options).meanJointPeak / kSeeds;
      }
      EXPECT_GT(mean, 0.8 * speed) << toString(kind);
      EXPECT_LT(mean, 1.25 * speed) << toString(kind);
    }
  }
}

TEST(SimulationLimits, StartsAndEndsAtRest) {
  for (const MotionKind kind : kKinds) {
    const auto simulated = simulate(RobotModel::panda(), sampleTool(), optionsFor(kind, 3));
    ASSERT_TRUE(simulated.ok()) << simulated.error().message;
    const Eigen::Index edge = 200;
    EXPECT_EQ(simulated->dq.topRows(edge).cwiseAbs().maxCoeff(), 0.0) << toString(kind);
    EXPECT_EQ(simulated->dq.bottomRows(edge).cwiseAbs().maxCoeff(), 0.0) << toString(kind);
    EXPECT_GT(simulated->dq.middleRows(edge, simulated->dq.rows() - 2 * edge).cwiseAbs().maxCoeff(), 0.3);
  }
}

TEST(SimulationLimits, VelocityAndAccelerationAreTheDerivatives) {
  for (const MotionKind kind : kKinds) {
    SCOPED_TRACE(toString(kind));
    SimulateOptions options = optionsFor(kind, 8, 12.0);
    options.rateHz = 2000.0;
    const auto simulated = simulate(RobotModel::panda(), sampleTool(), options);
    ASSERT_TRUE(simulated.ok()) << simulated.error().message;
    const Eigen::Index n = simulated->q.rows();
    const MatrixXd dq = (simulated->q.bottomRows(n - 2) - simulated->q.topRows(n - 2)) * (options.rateHz / 2.0);
    const MatrixXd ddq = (simulated->dq.bottomRows(n - 2) - simulated->dq.topRows(n - 2)) * (options.rateHz / 2.0);
    // Central differences err by h^2/6 times the third derivative: 500 rad/s3 here at most. Where a minimum-jerk leg
    // begins, the third derivative jumps and the error of ddq is h/4 times the jump.
    EXPECT_LT((dq - simulated->dq.middleRows(1, n - 2)).cwiseAbs().maxCoeff(), 2.5e-5);
    EXPECT_LT((ddq - simulated->ddq.middleRows(1, n - 2)).cwiseAbs().maxCoeff(), 0.02);
    EXPECT_GT(simulated->ddq.cwiseAbs().maxCoeff(), 1.0);
  }
}

TEST(SimulationLimits, FreeGuidingTremblesAndPauses) {
  const auto simulated = simulate(RobotModel::panda(), sampleTool(), optionsFor(MotionKind::free, 4));
  ASSERT_TRUE(simulated.ok()) << simulated.error().message;
  // A pause: all joints slower than tremor alone can be (0.87 mrad at 11 Hz is 60 mrad/s) for at least 0.15 s.
  Eigen::Index longest = 0, run = 0;
  for (Eigen::Index k = 1500; k < 18500; ++k) {
    run = simulated->dq.row(k).cwiseAbs().maxCoeff() < 0.07 ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  EXPECT_GT(longest, 150);
  // The second difference of ddq at a lag of half a tremor period takes out the slow part.
  double shake = 0.0;
  const Eigen::Index lag = 53;
  for (Eigen::Index k = 2000; k < 18000; ++k)
    shake +=
        std::abs(simulated->ddq(k - lag, 4) - 2.0 * simulated->ddq(k, 4) + simulated->ddq(k + lag, 4)) / 4.0 / 16000;
  EXPECT_GT(shake, 0.2);
  EXPECT_LT(shake, 3.0);
}

}  // namespace
}  // namespace heft
