#include "core/coach/coach.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/online/online_information.h"
#include "tests/core/coach/perform.h"

namespace heft {
namespace {

using test::dullMotion;
using test::Performer;
using test::width;

struct Followed {
  double share = 1.0;    ///< Width at the end over that at the beginning
  double promise = 1.0;  ///< Width after the first piece of advice over the promised one
  double moved = 0.0;    ///< [s]
};

/// Does what the coach says for ten seconds and checks all of it against the limits.
Followed follow(const Payload& payload, unsigned seed, CoachGoal want) {
  Performer arm(payload, seed);
  const GuidedTool tool = *guidedTool(RobotModel::panda(), arm.mount());
  Recording data = arm.perform(dullMotion(), 0.0);
  OnlineEstimator online = test::estimatorFor(data);
  test::feed(online, data);
  online.finish();
  const double before = width(online.state(), want);
  Followed out;
  double time = data.time(data.rows() - 1) + 0.2;
  VectorXd q = dullMotion().q.bottomRows(1).transpose();
  for (bool first = true;; first = false) {
    CoachOptions options;
    options.want = want;
    const auto advice = advise(online.information(), tool, arm.gravity(), q, options);
    if (!advice) {
      ADD_FAILURE() << advice.error().message;
      break;
    }
    if (!advice->needed || out.moved + advice->motion.duration() > 10.0) break;
    EXPECT_TRUE(advice->use.kept());
    EXPECT_LE(advice->use.largestTcpSpeed, kTcpSpeed);
    test::expectLimitsKept(advice->motion, tool, kTcpSpeed);
    EXPECT_THAT(advice->gain, testing::HasSubstr(" -> "));
    EXPECT_LT(advice->after.of(want), advice->before.of(want));
    EXPECT_EQ((advice->motion.q.row(0).transpose() - q).norm(), 0.0);
    data = arm.perform(advice->motion, time);
    test::feed(online, data);
    online.finish();
    if (first) out.promise = width(online.state(), want) / advice->after.of(want);
    out.moved += advice->motion.duration();
    time += advice->motion.duration() + 0.2;
    q = advice->motion.q.bottomRows(1).transpose();
  }
  out.share = width(online.state(), want) / before;
  return out;
}

class FollowedAdvice : public testing::TestWithParam<CoachGoal> {};

TEST_P(FollowedAdvice, HalvesTheIntervalInTenSecondsInsideAllLimits) {
  const Followed followed = follow(test::onlineTool(), 3, GetParam());
  EXPECT_LE(followed.moved, 10.0);
  EXPECT_LT(followed.share, 0.5);
  // What was promised is about what came.
  EXPECT_LT(followed.promise, 2.0);
  EXPECT_GT(followed.promise, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Quantities, FollowedAdvice,
                         testing::Values(CoachGoal::mass, CoachGoal::com, CoachGoal::inertia),
                         [](const auto& tested) { return std::string(toString(tested.param)); });

TEST(Coach, InertiaOfLightToolsIsHalvedToo) {
  // Their moments are the least told by turns about one axis at a time, two of which fill the ten seconds.
  for (const double mass : {0.2, 0.26}) {
    const Followed followed =
        follow(test::boxPayload(mass, {0.05, 0.07, 0.09}, {0.01, -0.01, 0.06}), 11, CoachGoal::inertia);
    EXPECT_LE(followed.moved, 10.0);
    EXPECT_LT(followed.share, 0.5) << mass;
  }
}

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

// A wall beside the tool: what is proposed there is smaller or another motion, and stays clear of it.
TEST(Coach, KeepsClearOfARoom) {
  const RobotModel& panda = RobotModel::panda();
  const GuidedTool tool = *guidedTool(panda, SensorMount{});
  const VectorXd home = panda.homePosture();
  HeldTool held{tool.link, tool.X_LS, parseShape("box:0.06,0.06,0.16@0,0,0.08").value()};
  held.shape->certainty = Certainty::exact;
  const Isometry3d X_BS = panda.linkPose(home, tool.link) * tool.X_LS;
  const auto roomWithAWall = [&](double away) {
    Room room;
    room.margin = 0.01;
    room.obstacles.push_back({"wall", RoomBox{{0.1, 0.02, 0.08},
                                              Isometry3d(Eigen::Translation3d(X_BS * Vector3d(0.0, 0.0, 0.12) +
                                                                              Vector3d(0.0, 0.04 + away, 0.0)))}});
    return room;
  };
  Findings findings;
  const auto swing = [&](const Clearance* clearance) {
    CoachOptions options;
    options.limits.clearance = clearance;
    return namedMotion("tilt-sideways", tool, home, options);
  };
  const auto size = [&](const Advice& advice) {
    return (advice.motion.q.rowwise() - home.transpose()).cwiseAbs().maxCoeff();
  };
  const auto freely = swing(nullptr);
  ASSERT_TRUE(freely);
  const Clearance near = std::move(Clearance::of(panda, held, roomWithAWall(0.05), findings).value());
  ASSERT_TRUE(near.firstConflict(freely->motion)) << "the wall is in the way of the whole motion";
  const auto beside = swing(&near);
  ASSERT_TRUE(beside) << beside.error().message;
  EXPECT_LT(size(*beside), size(*freely));
  EXPECT_FALSE(near.firstConflict(beside->motion));
  for (Eigen::Index k = 0; k < beside->motion.size(); ++k) {
    const Nearest nearest = near.nearest(beside->motion.q.row(k).transpose());
    EXPECT_GT(nearest.distance, nearest.margin - 0.001);
  }
  const Clearance touching = std::move(Clearance::of(panda, held, roomWithAWall(0.005), findings).value());
  const auto none = swing(&touching);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, testing::HasSubstr("wall"));
  const auto advised = advise(std::nullopt, tool, {0.0, 0.0, -9.81}, home, [&] {
    CoachOptions options;
    options.limits.clearance = &touching;
    return options;
  }());
  ASSERT_FALSE(advised);
  EXPECT_THAT(advised.error().message, testing::HasSubstr("stays clear"));
}

// What the arm holds grows until the joints cannot: before, the same motion is made smaller.
TEST(Coach, KeepsTheJointsTorques) {
  const GuidedTool tool = *guidedTool(RobotModel::panda(), SensorMount{});
  const VectorXd q = dullMotion().q.bottomRows(1).transpose();
  CoachOptions options;
  const auto unloaded = namedMotion("tilt-forwards", tool, q, options);
  ASSERT_TRUE(unloaded) << unloaded.error().message;
  EXPECT_GT(unloaded->use.torque.share, 0.1);
  EXPECT_THAT(unloaded->use.torque.joint, testing::StartsWith("panda_joint"));
  bool smaller = false, refused = false;
  for (double mass = 1.0; mass < 30.0 && !refused; mass += 0.5) {
    options.limits.payload = Payload{mass, {0.0, 0.0, 0.15}, Matrix3d::Zero()};
    const auto motion = namedMotion("tilt-forwards", tool, q, options);
    if (motion) {
      const TorqueUse whole = torqueUse(tool, unloaded->motion, options.limits);
      EXPECT_LE(torqueUse(tool, motion->motion, options.limits).share, 1.0) << mass;
      EXPECT_EQ(motion->motion.q == unloaded->motion.q, whole.share <= 1.0) << mass;
      smaller = smaller || whole.share > 1.0;
    } else {
      refused = true;
      EXPECT_THAT(motion.error().message, testing::ContainsRegex("Joint panda_joint[0-9] would need"));
    }
  }
  EXPECT_TRUE(smaller);
  EXPECT_TRUE(refused);
}

TEST(Coach, AMotionIsHadByItsNameAndKeepsTheLimits) {
  const GuidedTool tool = *guidedTool(RobotModel::panda(), SensorMount{});
  const VectorXd q = dullMotion().q.bottomRows(1).transpose();
  for (const char* id : {"tilt-sideways", "turn-slowly", "shake-forwards"}) {
    const auto advice = namedMotion(id, tool, q);
    ASSERT_TRUE(advice) << advice.error().message;
    EXPECT_EQ(advice->id, id);
    EXPECT_TRUE(advice->use.kept());
    EXPECT_EQ((advice->motion.q.row(0).transpose() - q).norm(), 0.0);
    EXPECT_GT((advice->target - q).norm(), 0.02);
  }
  EXPECT_FALSE(namedMotion("dance", tool, q));
  EXPECT_FALSE(namedMotion("tilt-sideways", tool, VectorXd::Constant(7, 9.0)));
}

}  // namespace
}  // namespace heft
