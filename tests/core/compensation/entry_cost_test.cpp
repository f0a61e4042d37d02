// What a wrong entry at the controller costs along a motion.
#include "core/compensation/entry_cost.h"

#include <gtest/gtest.h>

#include "core/wrench/regressor.h"
#include "tests/support/estimation_fixtures.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

const Payload kCarried = test::boxPayload(0.9, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06});
constexpr ControllerLimits kUsual{10.0, 10.0, 3000.0};

class EntryCostTest : public testing::Test {
 protected:
  EntryCostTest() {
    SimulateOptions options;
    options.motion = MotionKind::free;
    options.duration = 10.0;
    options.rateHz = 250.0;
    options.mount.xyz = {0.02, -0.01, 0.05};
    options.mount.rpy = {0.1, -0.2, 0.7};
    auto simulated = simulate(RobotModel::panda(), kCarried, options);
    if (!simulated) throw std::runtime_error(simulated.error().message);
    recording = std::move(simulated->recording);
    report = test::reportOf(recording);
    X_FS = poseFromXyzRpy(options.mount.xyz, options.mount.rpy);
    onFlange = transformed(report.payload, X_FS);
  }
  EntryCost costOf(const PartialPayload& told, const std::vector<Payload>& mounted = {}) const {
    auto cost = costOfEntry(told, report, mounted, kUsual, recording, &RobotModel::panda());
    if (!cost) throw std::runtime_error(cost.error().message);
    return *cost;
  }
  static PartialPayload whole(const Payload& payload) { return {payload.mass, payload.com, payload.inertiaCom}; }

  Recording recording;
  EstimateReport report;
  Isometry3d X_FS;
  Payload onFlange;
};

TEST_F(EntryCostTest, TheRightEntryCostsNothing) {
  const EntryCost cost = costOf(whole(onFlange));
  EXPECT_LT(cost.force, 1e-6);
  EXPECT_LT(cost.torque, 1e-6);
  EXPECT_NEAR(cost.sag, 0.0, 1e-9);
  EXPECT_FALSE(cost.differs);
  EXPECT_GT(cost.forceStd, 0.0);
  EXPECT_FALSE(costOf(whole(transformed(kCarried, X_FS))).differs) << "the truth lies within the intervals";
}

TEST_F(EntryCostTest, WhatIsMountedBesidesTheToolBelongsToTheEntry) {
  const Payload part = test::boxPayload(0.3, {0.05, 0.05, 0.03}, {0, 0, 0.015});
  EXPECT_FALSE(costOf(whole(composed(onFlange, part)), {part}).differs);
  const EntryCost forgotten = costOf(whole(onFlange), {part});
  EXPECT_TRUE(forgotten.differs);
  EXPECT_NEAR(forgotten.weight, 0.3 * 9.81, 1e-6);
}

TEST_F(EntryCostTest, ThePhantomIsTheLoadThatNobodyToldAsItActsOnTheFlange) {
  Payload told = onFlange;
  told.mass = 0.5;
  told.com += Vector3d(0.01, 0.0, -0.02);
  const EntryCost cost = costOf(whole(told));
  const auto motion = motionOf(recording, &RobotModel::panda(), {});
  ASSERT_EQ(cost.phantom.cols(), motion->size());
  const Isometry3d X_SF = X_FS.inverse();
  for (const Eigen::Index k : {Eigen::Index{0}, motion->size() / 3, motion->size() - 1}) {
    const WrenchState state{motion->specificForce.col(k), motion->omega.col(k), motion->alpha.col(k)};
    // Newton and Euler about the centre of mass, and the moments of the forces about the flange.
    const Vector6d missing = predictWrench(report.payload, state) - predictWrench(transformed(told, X_SF), state);
    const Vector3d force = X_FS.linear() * -missing.head<3>();
    const Vector3d torque = X_FS.linear() * -missing.tail<3>() + X_FS.translation().cross(force);
    EXPECT_TRUE(cost.phantom.col(k).head<3>().isApprox(force, 1e-9)) << k;
    EXPECT_TRUE(cost.phantom.col(k).tail<3>().isApprox(torque, 1e-9)) << k;
  }
  EXPECT_TRUE(cost.differs);
  EXPECT_NEAR(cost.weight, (report.payload.mass - 0.5) * 9.81, 1e-6);
  EXPECT_NEAR(cost.sag, cost.weight / 3000.0, 1e-12);
  EXPECT_GT(cost.force, 0.9 * cost.weight);
  EXPECT_NEAR(cost.forceShare, cost.force / 10.0, 1e-12);
  const auto below = (cost.phantom.topRows<3>().colwise().norm().array() <= cost.force).count();
  EXPECT_NEAR(static_cast<double>(below) / static_cast<double>(cost.time.size()), 0.99, 0.002);
}

TEST_F(EntryCostTest, PullsDownWhereTooLittleIsToldAndUpWhereTooMuch) {
  for (const double mass : {0.4, 1.4}) {
    const EntryCost cost = costOf({mass, {}, {}});
    EXPECT_FALSE(cost.centreTold);
    EXPECT_EQ(cost.told.com, cost.actual.com);
    const auto motion = motionOf(recording, &RobotModel::panda(), {});
    Vector3d mean_B = Vector3d::Zero();
    for (Eigen::Index k = 0; k < motion->size(); ++k)
      mean_B += motion->R_BS[static_cast<std::size_t>(k)] * X_FS.linear().transpose() * cost.phantom.col(k).head<3>();
    EXPECT_EQ(mean_B.z() < 0.0, mass < 0.9) << mass;
    EXPECT_EQ(cost.sag > 0.0, mass < 0.9) << mass;
  }
}

TEST_F(EntryCostTest, NothingEnteredCostsTheWholeWeight) {
  const EntryCost cost = costOf({0.0, {}, {}});
  EXPECT_NEAR(cost.weight, report.payload.mass * 9.81, 1e-6);
  EXPECT_TRUE(cost.differs);
}

TEST_F(EntryCostTest, StandingPosesHaveAPhantomEach) {
  constexpr Eigen::Index kPoses = 8;
  const Recording moving = recording;
  recording = {};
  recording.meta = moving.meta;
  recording.meta.kind = RecordingKind::poses;
  recording.time = VectorXd::LinSpaced(kPoses, 1.0, 8.0);
  recording.q.resize(kPoses, moving.q.cols());
  recording.wrench.setZero(kPoses, 6);
  for (Eigen::Index k = 0; k < kPoses; ++k) recording.q.row(k) = moving.q.row(300 * k);
  const EntryCost cost = costOf({0.5, {}, {}});
  ASSERT_EQ(cost.time.size(), recording.rows());
  EXPECT_NEAR(cost.phantom.col(0).head<3>().norm(), (report.payload.mass - 0.5) * 9.81, 1e-6);
}

TEST_F(EntryCostTest, SaysWhatIsMissing) {
  EXPECT_FALSE(costOfEntry({}, report, {}, kUsual, recording, &RobotModel::panda()));
  report.trust = Trust::none;
  const auto untrusted = costOfEntry(whole(onFlange), report, {}, kUsual, recording, &RobotModel::panda());
  ASSERT_FALSE(untrusted);
  EXPECT_NE(untrusted.error().message.find("not reliable"), std::string::npos);
}

}  // namespace
}  // namespace heft
