// The building blocks of motions.
#include "core/simulation/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/simulation/sample.h"

namespace heft {
namespace {

TEST(SimulationTrajectory, MinimumJerkIsSmoothAndItsDerivativesBelongTogether) {
  EXPECT_EQ(minimumJerk(-1.0).value, 0.0);
  EXPECT_EQ(minimumJerk(2.0).value, 1.0);
  EXPECT_DOUBLE_EQ(minimumJerk(0.5).value, 0.5);
  EXPECT_DOUBLE_EQ(minimumJerk(0.5).rate, 1.875);
  const double h = 1e-5;
  for (double u = 0.01; u < 1.0; u += 0.07) {
    const Jet a = minimumJerk(u - h), b = minimumJerk(u), c = minimumJerk(u + h);
    EXPECT_NEAR((c.value - a.value) / (2.0 * h), b.rate, 1e-8);
    EXPECT_NEAR((c.rate - a.rate) / (2.0 * h), b.second, 1e-7);
    EXPECT_NEAR(b.value + minimumJerk(1.0 - u).value, 1.0, 1e-14);
  }
}

TEST(SimulationTrajectory, ContactRisesAndFallsSmoothly) {
  for (const double edge : {0.0, 0.1, 0.4}) {
    const Contact contact{2.0, 3.0, edge, Vector3d::UnitZ(), Vector3d::Zero()};
    EXPECT_EQ(contact.level(1.99), 0.0);
    EXPECT_EQ(contact.level(2.0), 0.0);
    EXPECT_EQ(contact.level(3.0), 0.0);
    EXPECT_EQ(contact.level(3.01), 0.0);
    EXPECT_NEAR(contact.level(2.5), 1.0, 1e-12);
    EXPECT_NEAR(contact.level(2.2), contact.level(2.8), 1e-12);
    EXPECT_LT(contact.level(2.001), 0.01);
  }
}

TEST(SimulationTrajectory, TremorStaysInItsBoundsAndDerivativesBelongTogether) {
  std::vector<JointRoom> rooms(3, JointRoom{-2.0, 2.0, 2.0, 10.0, 1.0});
  const Tremor tremor(5, rooms, 0.2, 3.8, 0.5);
  const double h = 1e-5;
  auto jet = [&](double t) {
    VectorXd q = VectorXd::Zero(3), dq = q, ddq = q;
    tremor.add(t, q, dq, ddq);
    return std::array<VectorXd, 3>{q, dq, ddq};
  };
  double largest = 0.0;
  for (double t = 0.1; t < 3.95; t += 0.00917) {
    const auto a = jet(t - h), b = jet(t), c = jet(t + h);
    EXPECT_LT(((c[0] - a[0]) / (2.0 * h) - b[1]).cwiseAbs().maxCoeff(), 1e-6) << t;
    EXPECT_LT(((c[1] - a[1]) / (2.0 * h) - b[2]).cwiseAbs().maxCoeff(), 1e-3) << t;
    for (int j = 0; j < 3; ++j) {
      const Jet bound = tremor.bound(static_cast<std::size_t>(j));
      EXPECT_LE(std::abs(b[0](j)), bound.value);
      EXPECT_LE(std::abs(b[1](j)), bound.rate);
      EXPECT_LE(std::abs(b[2](j)), bound.second);
    }
    largest = std::max(largest, b[0].cwiseAbs().maxCoeff());
  }
  EXPECT_GT(largest, 2e-4);
  EXPECT_LT(largest, 9e-4);
  EXPECT_EQ(jet(0.1)[0].norm(), 0.0);
  EXPECT_EQ(jet(3.9)[0].norm(), 0.0);
}

TEST(SimulationTrajectory, ToolReachesTheTableAndTurns) {
  const RobotModel& robot = RobotModel::panda();
  const auto simulated = simulate(robot, sampleTool(), optionsFor(MotionKind::pickAndPlace, 12));
  ASSERT_TRUE(simulated.ok()) << simulated.error().message;
  const int link = robot.findLink("panda_link8").value();
  const Isometry3d home = robot.linkPose(robot.homePosture(), link);
  double lowest = 1e9, aside = 0.0, turn = 0.0;
  for (Eigen::Index k = 0; k < simulated->q.rows(); k += 20) {
    const Isometry3d X_BL = robot.linkPose(simulated->q.row(k), link);
    lowest = std::min(lowest, X_BL.translation().z());
    aside = std::max(aside, std::abs(X_BL.translation().y()));
    turn = std::max(turn, vectorFromRotation(home.linear().transpose() * X_BL.linear()).norm());
  }
  EXPECT_LT(lowest, home.translation().z() - 0.12);
  EXPECT_GT(aside, 0.08);
  EXPECT_GT(turn, 0.5);
}

}  // namespace
}  // namespace heft
