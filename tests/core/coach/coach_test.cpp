#include "core/coach/coach.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/coach/perform.h"

namespace heft {
namespace {

using test::dullMotion;
using test::Performer;
using test::width;

class FollowedAdvice : public testing::TestWithParam<CoachGoal> {};

TEST_P(FollowedAdvice, HalvesTheIntervalInTenSecondsInsideAllLimits) {
  const CoachGoal want = GetParam();
  Performer arm(test::onlineTool(), 3);
  const GuidedTool tool = *guidedTool(RobotModel::panda(), arm.mount());
  Recording data = arm.perform(dullMotion(), 0.0);
  OnlineEstimator online = test::estimatorFor(data);
  test::feed(online, data);
  online.finish();
  const double before = width(online.state(), want);
  double moved = 0.0, time = data.time(data.rows() - 1) + 0.2;
  VectorXd q = dullMotion().q.bottomRows(1).transpose();
  bool first = true;
  for (;;) {
    CoachOptions options;
    options.want = want;
    const auto advice = advise(online.information(), tool, arm.gravity(), q, options);
    ASSERT_TRUE(advice.ok()) << advice.error().message;
    if (!advice->needed || moved + advice->motion.duration() > 10.0) break;
    EXPECT_TRUE(advice->use.kept());
    EXPECT_LE(advice->use.largestTcpSpeed, kTcpSpeed);
    test::expectLimitsKept(advice->motion, tool, kTcpSpeed);
    EXPECT_THAT(advice->gain, testing::HasSubstr(" -> "));
    EXPECT_LT(advice->after.of(want), advice->before.of(want));
    EXPECT_EQ((advice->motion.q.row(0).transpose() - q).norm(), 0.0);
    data = arm.perform(advice->motion, time);
    test::feed(online, data);
    online.finish();
    if (first) {
      // What was promised is about what came.
      EXPECT_LT(width(online.state(), want), 2.0 * advice->after.of(want)) << advice->id;
      EXPECT_GT(width(online.state(), want), 0.5 * advice->after.of(want)) << advice->id;
      first = false;
    }
    moved += advice->motion.duration();
    time += advice->motion.duration() + 0.2;
    q = advice->motion.q.bottomRows(1).transpose();
  }
  EXPECT_LE(moved, 10.0);
  EXPECT_LT(width(online.state(), want), 0.5 * before);
}

INSTANTIATE_TEST_SUITE_P(Quantities, FollowedAdvice, testing::Values(CoachGoal::mass, CoachGoal::com, CoachGoal::inertia),
                         [](const auto& tested) { return std::string(toString(tested.param)); });

TEST(Coach, BeginsWithATiltWhenNothingIsKnown) {
  const GuidedTool tool = *guidedTool(RobotModel::panda(), Performer(test::onlineTool(), 1).mount());
  const auto advice = advise({}, tool, {0, 0, -9.81}, RobotModel::panda().homePosture());
  ASSERT_TRUE(advice.ok());
  EXPECT_THAT(advice->sentence, testing::HasSubstr("Tilt"));
  EXPECT_TRUE(advice->gain.empty());
  EXPECT_EQ(advice->target.size(), 7);
  EXPECT_GT((advice->target - RobotModel::panda().homePosture()).norm(), 0.1);
}

TEST(Coach, SlowerCapMakesSlowerMotions) {
  const GuidedTool tool = *guidedTool(RobotModel::panda(), Performer(test::onlineTool(), 1).mount());
  CoachOptions options;
  options.limits.tcpSpeed = 0.01;
  const auto advice = advise({}, tool, {0, 0, -9.81}, RobotModel::panda().homePosture(), options);
  ASSERT_TRUE(advice.ok());
  test::expectLimitsKept(advice->motion, tool, 0.01);
}

TEST(Coach, RefusesPosturesOutsideTheRanges) {
  const GuidedTool tool = *guidedTool(RobotModel::panda(), Performer(test::onlineTool(), 1).mount());
  VectorXd q = RobotModel::panda().homePosture();
  q(3) = 1.0;
  const auto advice = advise({}, tool, {0, 0, -9.81}, q);
  ASSERT_FALSE(advice.ok());
  EXPECT_THAT(advice.error().message, testing::HasSubstr("range"));
  SensorMount mount;
  mount.parent = "nowhere";
  EXPECT_FALSE(guidedTool(RobotModel::panda(), mount).ok());
}

TEST(Coach, WordsSayTheGain) {
  Uncertainty before, after;
  before.com = 0.004 / 1.96;
  after.com = 0.001 / 1.96;
  EXPECT_EQ(gainWords(CoachGoal::com, before, after), "centre of mass ± 4.0 mm -> ± 1.0 mm");
  EXPECT_EQ(quantityFromString("inertia"), CoachGoal::inertia);
  EXPECT_FALSE(quantityFromString("colour").has_value());
}

TEST(JointMotion, QuinticsMeetTheSamplesAndTheirDerivatives) {
  const JointMotion motion = dullMotion();
  VectorXd q, dq, ddq, later, rate, second;
  for (const Eigen::Index k : {0, 57, 200}) {
    motion.at(motion.time(k), q, dq, ddq);
    EXPECT_LT((q - motion.q.row(k).transpose()).norm(), 1e-12);
    EXPECT_LT((dq - motion.dq.row(k).transpose()).norm(), 1e-10);
    EXPECT_LT((ddq - motion.ddq.row(k).transpose()).norm(), 1e-8);
  }
  motion.at(1.2345, q, dq, ddq);
  motion.at(1.2345 + 1e-6, later, rate, second);
  EXPECT_LT(((later - q) / 1e-6 - dq).norm(), 1e-5);
  EXPECT_LT(((rate - dq) / 1e-6 - ddq).norm(), 1e-4);
  EXPECT_NEAR(motion.slower(2.0).duration(), 8.0, 1e-12);
}

}  // namespace
}  // namespace heft
