#include "core/coach/pose_guide.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/coach/perform.h"

namespace heft {
namespace {

const Vector3d kGravity(0.0, 0.0, -9.81);

/// A standing tool whose sensor axes are turned by `rpy`.
StandingPose poseAt(const Payload& tool, const Vector3d& rpy, const Vector6d& bias) {
  StandingPose pose;
  pose.R_BS = rotationFromRpy(rpy);
  pose.wrench = predictWrench(tool, {pose.R_BS.transpose() * -kGravity, Vector3d::Zero(), Vector3d::Zero()}) + bias;
  return pose;
}

Vector6d someBias() {
  Vector6d bias;
  bias << 2.0, -1.0, 3.0, 0.1, -0.05, 0.02;
  return bias;
}

const std::vector<Vector3d> kTilts{{0, 0, 0},    {0.8, 0, 0}, {-0.8, 0, 0},  {0, 0.8, 0},
                                   {0, -0.8, 0}, {1.5, 0, 0}, {0.6, 0.9, 0}, {3.1, 0.2, 0}};

TEST(PoseGuide, EightPosesGiveMassAndCentre) {
  const Payload tool = test::onlineTool();
  PoseGuide guide({}, kGravity);
  EXPECT_FALSE(guide.result().known);
  for (const auto& tilt : kTilts) guide.add(poseAt(tool, tilt, someBias()));
  EXPECT_EQ(guide.usedCount(), 8);
  const PoseResult& result = guide.result();
  EXPECT_TRUE(result.known);
  EXPECT_EQ(result.spread, ExcitationLight::good) << result.spreadWords;
  EXPECT_NEAR(result.mass, tool.mass, 1e-3);
  EXPECT_LT((result.com - tool.com).norm(), 1e-3);
  EXPECT_LT((result.bias - someBias()).norm(), 1e-2);
  EXPECT_LT(result.massStd, 0.03);
}

TEST(PoseGuide, EachPoseHasItsLight) {
  const Payload tool = test::onlineTool();
  PoseGuide guide({}, kGravity);
  for (const auto& tilt : kTilts) guide.add(poseAt(tool, tilt, someBias()));
  StandingPose close = poseAt(tool, {0.85, 0.0, 0.0}, someBias());
  StandingPose moving = poseAt(tool, {-1.4, 0.3, 0.0}, someBias());
  moving.speed = 0.2;
  StandingPose touched = poseAt(tool, {0.5, -0.9, 0.0}, someBias());
  touched.wrench(0) += 3.0;
  guide.add(close);
  guide.add(moving);
  guide.add(touched);
  const auto& poses = guide.poses();
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(poses[i].light, PoseLight::used) << i << poses[i].words;
  EXPECT_EQ(poses[8].light, PoseLight::tooClose);
  EXPECT_THAT(poses[8].words, testing::HasSubstr("pose 2"));
  EXPECT_EQ(poses[9].light, PoseLight::moving);
  EXPECT_EQ(poses[10].light, PoseLight::contact);
  EXPECT_NEAR(poses[10].misfit, 3.0, 0.2);
  EXPECT_NEAR(guide.result().mass, tool.mass, 1e-3);
  guide.remove(10);
  EXPECT_EQ(guide.poses().size(), 10u);
}

TEST(PoseGuide, SpreadIsJudged) {
  const Payload tool = test::onlineTool();
  PoseGuide one({}, kGravity);
  one.add(poseAt(tool, {0, 0, 0}, someBias()));
  one.add(poseAt(tool, {0, 0, 1.0}, someBias()));  // about gravity: no other tilt
  EXPECT_EQ(one.poses()[1].light, PoseLight::tooClose);
  EXPECT_EQ(one.result().spread, ExcitationLight::none);
  EXPECT_THAT(one.result().spreadWords, testing::HasSubstr("same orientation"));
  PoseGuide axis({}, kGravity);
  for (const double roll : {-0.25, 0.0, 0.25}) axis.add(poseAt(tool, {roll, 0, 0}, someBias()));
  EXPECT_FALSE(axis.result().known);
  EXPECT_THAT(axis.result().spreadWords, testing::HasSubstr("one axis"));
}

TEST(PoseGuide, ProposedPosesLeadToTheResult) {
  const Payload tool = test::onlineTool();
  test::Performer arm(tool, 4);
  const GuidedTool guided = *guidedTool(RobotModel::panda(), arm.mount());
  PoseGuide guide(guided, kGravity);
  VectorXd q = RobotModel::panda().homePosture();
  double time = 0.0, promised = INFINITY;
  for (int i = 0; i < 8; ++i) {
    // The arm moves there, unseen, and stands for a little longer than needed.
    const Recording still = arm.perform(test::Performer::hold(q, 1.3), time);
    time += 3.0;
    int taken = 0;
    for (Eigen::Index k = 0; k < still.rows(); ++k) taken += guide.add(sampleOf(still, k)) ? 1 : 0;
    EXPECT_EQ(taken, 1) << i;
    EXPECT_EQ(guide.poses().back().light, PoseLight::used) << guide.poses().back().words;
    const auto next = guide.next(q);
    ASSERT_TRUE(next.has_value());
    EXPECT_EQ(RobotModel::panda().clampToLimits(next->q), next->q);
    EXPECT_LE(next->massStd, 1.01 * guide.result().massStd);
    promised = next->massStd;
    q = next->q;
  }
  EXPECT_EQ(guide.result().spread, ExcitationLight::good) << guide.result().spreadWords;
  EXPECT_TRUE(guide.result().known);
  EXPECT_NEAR(guide.result().mass, tool.mass, 0.01);
  EXPECT_LT((guide.result().com - tool.com).norm(), 0.003);
  EXPECT_NEAR(promised, guide.result().massStd, 0.3 * guide.result().massStd);
}

TEST(PoseGuide, AMovingToolIsNoPose) {
  test::Performer arm(test::onlineTool(), 5);
  const GuidedTool guided = *guidedTool(RobotModel::panda(), arm.mount());
  PoseGuide guide(guided, kGravity);
  JointMotion motion = test::Performer::hold(RobotModel::panda().homePosture(), 4.0);
  motion.q.col(5) += 0.1 * motion.time;
  motion.dq.col(5).setConstant(0.1);
  const Recording data = arm.perform(motion, 0.0);
  for (Eigen::Index k = 0; k < data.rows(); ++k) EXPECT_FALSE(guide.add(sampleOf(data, k)));
  OnlineSample bad = sampleOf(data, 0);
  bad.wrench(1) = NAN;
  EXPECT_FALSE(guide.add(bad));
}

}  // namespace
}  // namespace heft
