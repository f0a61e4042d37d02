// Which joints become q's columns, for the kinds of robots that people have.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/robot_model.h"
#include "tests/core/robot/urdf_samples.h"

namespace heft {
namespace {

using samples::chain;
using samples::joint;
using samples::kLimit;
using samples::link;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string mimic(const std::string& leader, const std::string& more = "") {
  return "<axis xyz=\"0 0 1\"/>" + std::string(kLimit) + "<mimic joint=\"" + leader + "\"" + more + "/>";
}

RobotModel read(const std::string& inside, Findings* out = nullptr) {
  Findings findings;
  Result<RobotModel> model = RobotModel::fromUrdfText(samples::robot(inside), ".", findings);
  if (out) *out = findings;
  if (!model) throw std::runtime_error(model.error().message);
  return std::move(model).value();
}

std::vector<std::string> columns(const RobotModel& model) {
  std::vector<std::string> names;
  for (const int k : model.movingJoints()) names.push_back(model.joints()[k].name);
  return names;
}

bool isHeld(const RobotModel& model, const std::string& name) {
  for (const Joint& candidate : model.joints()) {
    if (candidate.name == name) return candidate.type == JointType::fixed && candidate.index == -1;
  }
  throw std::runtime_error("no joint " + name);
}

const std::string kSlide =
    std::string("<axis xyz=\"0 1 0\"/>") + R"(<limit lower="0" upper="0.04" velocity="1" effort="1"/>)";

TEST(MainChain, leadsToTheLinkThatCarriesTheSensor) {
  const std::string arms = link("b") + chain("rrrrrrf", "b", "left_") + chain("rrrrrrf", "b", "right_");
  const auto columnsFor = [&](const std::string& sensorLink) {
    Findings findings;
    return columns(RobotModel::fromUrdfText(samples::robot(arms), ".", findings, sensorLink).value());
  };
  EXPECT_THAT(columnsFor("right_l7"),
              ElementsAre("right_j1", "right_j2", "right_j3", "right_j4", "right_j5", "right_j6"));
  EXPECT_EQ(columnsFor("right_l3").size(), 6u);  // a sensor in the middle: the arm goes on behind it
  EXPECT_EQ(columnsFor("right_l3")[0], "right_j1");
  EXPECT_EQ(columnsFor("left_l7")[5], "left_j6");
  EXPECT_EQ(columnsFor("")[0], "left_j1");
  EXPECT_EQ(columnsFor("of another robot")[0], "left_j1");
}

TEST(MainChain, aShorterArmWithTheSensorIsTakenBeforeALongerOne) {
  const std::string arms = link("b") + chain("rrrrrrr", "b", "long_") + chain("rrrrr", "b", "short_");
  Findings findings;
  const auto model = RobotModel::fromUrdfText(samples::robot(arms), ".", findings, "short_l5").value();
  EXPECT_EQ(model.dof(), 5);
  EXPECT_TRUE(isHeld(model, "long_j1"));
  // A sensor on the palm does not let a hand's fingers move.
  const std::string hand = link("b") + chain("rrrrrrf") + chain("rrr", "l7", "a_") + chain("rrr", "l7", "c_");
  EXPECT_EQ(RobotModel::fromUrdfText(samples::robot(hand), ".", findings, "l7").value().dof(), 6);
}

TEST(MainChain, slidingFingersAreHeld) {
  Findings findings;
  const RobotModel model =
      read(link("b") + chain("rrrrrrrf") + link("f1") + link("f2") + joint("finger1", "prismatic", "l8", "f1", kSlide) +
               joint("finger2", "prismatic", "l8", "f2", kSlide + "<mimic joint=\"finger1\"/>"),
           &findings);
  EXPECT_THAT(columns(model), ElementsAre("j1", "j2", "j3", "j4", "j5", "j6", "j7"));
  EXPECT_TRUE(isHeld(model, "finger1"));
  EXPECT_TRUE(isHeld(model, "finger2"));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].code, "joints_held");
  EXPECT_EQ(findings[0].severity, Severity::info);
  EXPECT_THAT(findings[0].text, HasSubstr("finger1, finger2"));
  EXPECT_GT(findings[0].where.line, 1);
}

TEST(MainChain, turningFingersThatMimicOneAreHeld) {
  const RobotModel model = read(link("b") + chain("rrrrrr") + chain("r", "l6", "left_") + link("r1") + link("r2") +
                                joint("right", "revolute", "l6", "r1", mimic("left_j1")) +
                                joint("tip", "revolute", "r1", "r2", mimic("left_j1")));
  EXPECT_EQ(model.dof(), 6);
  EXPECT_TRUE(isHeld(model, "left_j1"));
  EXPECT_TRUE(isHeld(model, "tip"));
}

TEST(MainChain, handWithManyFingersIsHeld) {
  const RobotModel model = read(link("b") + chain("rrrrrr") + chain("rrrr", "l6", "index_") +
                                chain("rrrr", "l6", "middle_") + chain("rrrr", "l6", "thumb_"));
  EXPECT_THAT(columns(model), ElementsAre("j1", "j2", "j3", "j4", "j5", "j6"));
}

TEST(MainChain, scaraKeepsItsSlide) {
  EXPECT_THAT(columns(read(link("b") + chain("rrpr"))), ElementsAre("j1", "j2", "j3", "j4"));
  EXPECT_THAT(columns(read(link("b") + chain("rrrp"))), ElementsAre("j1", "j2", "j3", "j4"));
}

TEST(MainChain, gantryOfSlidesOnly) { EXPECT_EQ(read(link("b") + chain("pppf")).dof(), 3); }

TEST(MainChain, armOnARail) { EXPECT_EQ(read(link("b") + chain("fprrrrrr")).dof(), 7); }

TEST(MainChain, oneOfTwoArmsIsTaken) {
  const RobotModel model = read(link("b") + chain("r", "b", "torso_") + chain("rrrrrr", "torso_l1", "a_") +
                                chain("rrrrrrr", "torso_l1", "z_"));
  EXPECT_EQ(model.dof(), 8);
  EXPECT_EQ(columns(model).front(), "torso_j1");
  EXPECT_EQ(columns(model).back(), "z_j7");
  EXPECT_TRUE(isHeld(model, "a_j3"));
}

TEST(MainChain, sideBranchesOfAnArmDoNotEndIt) {
  // A camera that turns on link 2 and a cover that follows joint 2, as on palletisers.
  const RobotModel model =
      read(link("b") + chain("rrrrrr") + chain("r", "l2", "camera_") + link("cover") +
           joint("cover_joint", "revolute", "l1", "cover", mimic("j2", R"( multiplier="-2" offset="0.1")")));
  EXPECT_THAT(columns(model), ElementsAre("j1", "j2", "j3", "j4", "j5", "j6"));
  EXPECT_TRUE(isHeld(model, "camera_j1"));
  VectorXd q = VectorXd::Zero(6);
  q[1] = 0.3;
  const Isometry3d X = model.linkPose(q, *model.findLink("cover"));
  EXPECT_LT((X.linear() - rotationFromRpy({0, 0, -2 * 0.3 + 0.1})).norm(), 1e-12);
  EXPECT_EQ(model.jacobian(*model.findLink("cover"), Isometry3d::Identity(), q)(5, 1), -2.0);
}

TEST(MainChain, mimicOfAMimicFollowsToo) {
  const RobotModel model =
      read(link("b") + chain("rr") + link("m1") + link("m2") +
           joint("first", "revolute", "l1", "m1", mimic("j2", R"( multiplier="2" offset="0.5")")) +
           joint("second", "revolute", "l1", "m2", mimic("first", R"( multiplier="-1" offset="0.1")")));
  VectorXd q(2);
  q << 0.2, 0.4;
  const Isometry3d X_1 = model.linkPose(q, *model.findLink("l1"));
  const Isometry3d X = X_1.inverse() * model.linkPose(q, *model.findLink("m2"));
  EXPECT_LT((X.linear() - rotationFromRpy({0, 0, -(2 * 0.4 + 0.5) + 0.1})).norm(), 1e-12);
}

TEST(MainChain, mimicRingIsHeld) {
  const RobotModel model =
      read(link("b") + chain("rr") + link("m1") + link("m2") + joint("a", "revolute", "l2", "m1", mimic("z")) +
           joint("z", "revolute", "l2", "m2", mimic("a")));
  EXPECT_EQ(model.dof(), 2);
  EXPECT_TRUE(isHeld(model, "a"));
}

TEST(MainChain, heldJointStandsAtItsNearestLimit) {
  const std::string far = R"(<axis xyz="0 0 1"/><limit lower="0.3" upper="1" velocity="1" effort="1"/>)";
  const RobotModel model =
      read(link("b") + chain("rrrr") + link("side") + joint("side_joint", "revolute", "l1", "side", far));
  const Isometry3d X = model.linkPose(VectorXd::Zero(4), *model.findLink("side"));
  EXPECT_LT((X.linear() - rotationFromRpy({0, 0, 0.3})).norm(), 1e-12);
}

TEST(MainChain, nothingThatMovesIsAnError) {
  Findings findings;
  const auto model = RobotModel::fromUrdfText(samples::robot(link("b") + chain("ff")), ".", findings);
  ASSERT_FALSE(model);
  EXPECT_THAT(model.error().message, HasSubstr("no joint that moves"));
}

}  // namespace
}  // namespace heft
