#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "core/simulation/sensor.h"
#include "core/simulation/virtual_rig.h"
#include "core/wrench/regressor.h"

namespace heft {
namespace {

ToolFrame sensorFrame(const RobotModel& robot) {
  return {*robot.findLink("panda_link8"), poseFromXyzRpy({0, 0, 0.04}, Vector3d::Zero())};
}

/// Steps the arm and checks at every step that no limit is passed and that the motion is one motion.
class Watched {
 public:
  explicit Watched(GuidedArm& arm) : arm_(arm) {}
  void run(double seconds) {
    constexpr double dt = 1e-3;
    for (int k = 0; k < seconds / dt; ++k) {
      const VectorXd q = arm_.q(), dq = arm_.dq(), ddq = arm_.ddq();
      arm_.step(dt);
      for (int j = 0; j < arm_.robot().dof(); ++j) {
        const JointLimits& limits = arm_.robot().limits(j);
        ASSERT_GE(arm_.q()(j), limits.lower) << "joint " << j;
        ASSERT_LE(arm_.q()(j), limits.upper) << "joint " << j;
        ASSERT_LE(std::abs(arm_.dq()(j)), limits.velocity) << "joint " << j;
        ASSERT_LE(std::abs(arm_.ddq()(j)), limits.acceleration) << "joint " << j;
      }
      ASSERT_LE(cartesianLoad(arm_.robot(), arm_.tool(), arm_.q(), arm_.dq(), arm_.ddq()), 1.0);
      // Trapezoids of the rates give the changes: to the third order in dt.
      const VectorXd jump = arm_.q() - q - 0.5 * dt * (dq + arm_.dq()) + dt * dt / 12 * (arm_.ddq() - ddq);
      ASSERT_LT(jump.cwiseAbs().maxCoeff(), 1e-9);
    }
  }

 private:
  GuidedArm& arm_;
};

TEST(GuidedArm, FollowsThePullAndRestsThere) {
  GuidedArm arm(RobotModel::panda(), sensorFrame(RobotModel::panda()));
  Isometry3d goal = arm.pose();
  goal.translation() += Vector3d(0.05, 0.18, 0.1);
  goal.linear() = goal.linear() * rotationFromVector({0.5, -0.3, 0.4});
  arm.pullTo(goal);
  Watched(arm).run(4.0);
  EXPECT_LT((arm.pose().translation() - goal.translation()).norm(), 1e-3);
  EXPECT_LT(vectorFromRotation(arm.pose().linear().transpose() * goal.linear()).norm(), 4e-3);
  const VectorXd q = arm.q();
  arm.letGo();
  Watched(arm).run(1.5);
  EXPECT_TRUE(arm.atRest());
  EXPECT_LT((arm.q() - q).cwiseAbs().maxCoeff(), 0.01);
}

TEST(GuidedArm, WhatCannotBeReachedIsApproachedInsideAllLimits) {
  GuidedArm arm(RobotModel::panda(), sensorFrame(RobotModel::panda()));
  Isometry3d goal = arm.pose();
  goal.translation() = Vector3d(3.0, 0.5, 0.4);
  arm.pullTo(goal);
  Watched(arm).run(5.0);
  EXPECT_GT(arm.pose().translation().norm(), 0.75) << "stretched towards it";
  arm.letGo();
  Watched(arm).run(2.0);
  EXPECT_TRUE(arm.atRest());
}

TEST(GuidedArm, AWildHandBreaksNoLimit) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    RandomStream random(seed, RandomPurpose::motion);
    GuidedArm arm(RobotModel::panda(), sensorFrame(RobotModel::panda()));
    const Isometry3d home = arm.pose();
    for (int tug = 0; tug < 25; ++tug) {
      Isometry3d goal = home;
      for (int a = 0; a < 3; ++a) goal.translation()(a) += random.uniform(-0.9, 0.9);
      goal.linear() =
          home.linear() * rotationFromVector({random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)});
      arm.pullTo(goal);
      ASSERT_NO_FATAL_FAILURE(Watched(arm).run(random.uniform(0.05, 1.5)));
    }
  }
}

TEST(GuidedArm, GoesToThePathAndFollowsIt) {
  GuidedArm arm(RobotModel::panda(), sensorFrame(RobotModel::panda()));
  const VectorXd home = arm.q();
  arm.wander();
  Watched(arm).run(3.0);
  GuidedPath path;
  path.duration = 2.0;
  path.at = [home](double t, VectorXd& q, VectorXd& dq, VectorXd& ddq) {
    const Jet jet = minimumJerk(t / 2.0);
    q = home, dq.setZero(home.size()), ddq.setZero(home.size());
    q(6) += 0.4 * jet.value, dq(6) = 0.2 * jet.rate, ddq(6) = 0.1 * jet.second;
  };
  arm.follow(path);
  for (int k = 0; k < 10000 && !arm.atRest(); ++k) arm.step(1e-3);
  EXPECT_TRUE(arm.atRest());
  EXPECT_NEAR(arm.q()(6), home(6) + 0.4, 1e-3);
  arm.goTo(home);
  for (int k = 0; k < 10000 && !arm.atRest(); ++k) arm.step(1e-3);
  EXPECT_LT((arm.q() - home).cwiseAbs().maxCoeff(), 1e-3);
}

VirtualRigOptions quiet() {
  VirtualRigOptions options;
  options.payload = practiceTool(4);
  SensorModel& s = options.sensor;
  s.forceNoise = s.torqueNoise = s.colouredForce = s.colouredTorque = s.forceBias = s.torqueBias = 0.0;
  s.forceResolution.setZero();
  s.torqueResolution.setZero();
  options.positionNoise = options.velocityQuantum = 0.0;
  return options;
}

TEST(VirtualRig, AQuietSensorMeasuresWhatTheMotionNeeds) {
  const RobotModel& robot = RobotModel::panda();
  const VirtualRigOptions options = quiet();
  auto rig = VirtualRig::create(robot, options);
  ASSERT_TRUE(rig.ok());
  rig->arm().wander();
  std::vector<VirtualSample> samples;
  for (int k = 0; k < 3000; ++k) samples.push_back(rig->next());
  const ToolFrame tool = sensorFrame(robot);
  double largest = 0.0;
  for (std::size_t k = 500; k + 1 < samples.size(); k += 97) {
    // The accelerations from the reported speeds alone.
    const VectorXd ddq = (samples[k + 1].dq - samples[k - 1].dq) / 2e-3;
    const FrameMotion motion = robot.frameMotion(tool.link, tool.X_LS, samples[k].q, samples[k].dq, ddq);
    const Matrix3d R_SB = motion.X_BS.linear().transpose();
    const Vector6d expected = predictWrench(
        options.payload, {R_SB * (motion.a_BSo_B - options.gravity), R_SB * motion.w_BS_B, R_SB * motion.alpha_BS_B});
    largest = std::max(largest, motion.alpha_BS_B.norm());
    EXPECT_LT((samples[k].wrench - expected).cwiseAbs().maxCoeff(), 0.01);
  }
  EXPECT_GT(largest, 3.0) << "moves enough to tell an inertia";
}

TEST(VirtualRig, TheSameSeedGivesTheSameSamplesAndAnotherToolAnotherWeight) {
  VirtualRigOptions options;
  options.payload = practiceTool(1);
  auto a = VirtualRig::create(RobotModel::panda(), options), b = VirtualRig::create(RobotModel::panda(), options);
  for (int k = 0; k < 50; ++k) {
    const Vector6d wa = a->next().wrench, wb = b->next().wrench;
    ASSERT_EQ(wa, wb);
  }
  Payload heavier = options.payload;
  heavier.mass += 1.0;
  ASSERT_TRUE(b->changeTool(heavier).ok());
  EXPECT_NEAR((a->next().wrench - b->next().wrench).head<3>().norm(), 9.81, 0.1);
  EXPECT_FALSE(b->changeTool(Payload()).ok());
}

TEST(VirtualRig, PracticeToolsCanExistAndDiffer) {
  double lightest = 9, heaviest = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Payload tool = practiceTool(seed);
    ASSERT_TRUE(checkPhysical(tool).physical) << checkPhysical(tool).reason;
    lightest = std::min(lightest, tool.mass);
    heaviest = std::max(heaviest, tool.mass);
  }
  EXPECT_GE(lightest, 0.25);
  EXPECT_LE(heaviest, 1.6);
  EXPECT_GT(heaviest / lightest, 4);
  // The same with every compiler.
  EXPECT_NEAR(practiceTool(1).mass, 1.1739988028, 1e-9);
  EXPECT_NEAR(practiceTool(1).inertiaCom(0, 0), 0.00358003781688, 1e-13);
}

TEST(SensorNoise, OneByOneIsTheSameAsAllAtOnce) {
  SensorModel sensor;
  sensor.forceWalk = 0.1;
  SensorNoise stream(sensor, 9, 500.0);
  const SampledWrench all = drawNoise(sensor, 9, 500.0, 40);
  for (Eigen::Index k = 0; k < 40; ++k) EXPECT_EQ(stream.next().transpose(), all.row(k));
}

}  // namespace
}  // namespace heft
