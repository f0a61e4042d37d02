#include "core/collision/clearance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/collision/random_motion.h"

namespace heft {
namespace {

const RobotModel& panda() { return RobotModel::panda(); }

Clearance clearanceOf(const std::string& shape, const Room& room) {
  HeldTool tool{*panda().findLink("panda_link8"), Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.04)), std::nullopt};
  if (!shape.empty()) {
    tool.shape = parseShape(shape).value();
    tool.shape->certainty = Certainty::exact;
  }
  Findings findings;
  auto made = Clearance::of(panda(), tool, room, findings);
  if (!made) throw std::runtime_error(made.error().message);
  return std::move(*made);
}

VectorXd posture(std::initializer_list<double> q) { return Eigen::Map<const VectorXd>(q.begin(), 7); }

Room withTable(double height) {
  Room room;
  room.obstacles.push_back({"table", RoomPlane{{0.0, 0.0, height}, Vector3d::UnitZ()}});
  return room;
}

TEST(Clearance, DistanceToATableIsThatOfTheLowestPoint) {
  const VectorXd home = panda().homePosture();
  // The exact shape is grown by 0.8 %; the flange looks straight down in the home posture.
  const Isometry3d X_BL = panda().linkPose(home, *panda().findLink("panda_link8"));
  const Vector3d tip = X_BL * Vector3d(0.0, 0.0, 0.14);
  Room room;
  room.obstacles.push_back(
      {"table", RoomBox{{0.3, 0.3, 0.02}, Isometry3d(Eigen::Translation3d(tip - Vector3d(0.0, 0.0, 0.04)))}});
  const Clearance clearance = clearanceOf("box:0.06,0.06,0.1@0,0,0.05", room);
  const Nearest nearest = clearance.nearest(home);
  ASSERT_GT(X_BL.linear()(2, 2), -1.0001);
  EXPECT_THAT(nearest.first, testing::HasSubstr("tool"));
  EXPECT_EQ(nearest.second, "table");
  EXPECT_NEAR(nearest.distance, 0.03, 0.002);
}

TEST(Clearance, KnownCollisionsAreNamedAtTheirMoment) {
  const VectorXd home = panda().homePosture();
  // Down on the table: the second and fourth joint lean the arm over.
  const VectorXd down = posture({0.0, 0.9, 0.0, -1.9, 0.0, 2.8, 0.785});
  const Clearance onTable = clearanceOf("cylinder:0.03,0.15@0,0,0.075", withTable(0.05));
  const auto table = onTable.firstConflict(straightMotion(home, down, 4.0));
  ASSERT_TRUE(table);
  EXPECT_EQ(table->bodies.second, "table");
  EXPECT_GT(table->time, 0.2);
  EXPECT_LT(table->time, 4.0);
  EXPECT_THAT(table->sentence(), testing::HasSubstr("table"));
  EXPECT_FALSE(
      clearanceOf("cylinder:0.03,0.15@0,0,0.075", withTable(-1.5)).firstConflict(straightMotion(home, home, 4.0)));

  // A long tool folded back against the arm: wrist fully bent, elbow closed.
  const VectorXd folded = posture({0.0, -1.5, 0.0, -3.0, 0.0, 0.1, 0.785});
  const auto arm = clearanceOf("box:0.05,0.05,0.5@0,0,0.25", {}).firstConflict(straightMotion(home, folded, 4.0));
  ASSERT_TRUE(arm);
  EXPECT_THAT(arm->bodies.first + arm->bodies.second, testing::HasSubstr("tool"));
  EXPECT_THAT(arm->bodies.first, testing::HasSubstr("panda_link"));

  // Without a tool: the hand itself reaches the base when the arm bends down over it.
  const VectorXd overBase = posture({0.0, 0.4, 0.0, -3.0, 0.0, 2.2, 0.785});
  const auto base = clearanceOf("", {}).firstConflict(straightMotion(home, overBase, 4.0));
  ASSERT_TRUE(base);
  EXPECT_THAT(base->bodies.first, testing::StartsWith("panda_link"));
}

TEST(Clearance, ThinWallsAndWhatIsInsideAreSeen) {
  const VectorXd home = panda().homePosture();
  VectorXd turned = home;
  turned(0) += 2.0;
  Room room;
  Isometry3d X_BO = Isometry3d::Identity();
  X_BO.linear() = rotationFromVector({0.0, 0.0, home(0) + 1.0});
  X_BO.translation() = X_BO.linear() * Vector3d(0.45, 0.0, 0.6);
  room.obstacles.push_back({"sheet", RoomBox{{0.4, 0.001, 0.8}, X_BO}});
  const auto sheet = clearanceOf("", room).firstConflict(straightMotion(home, turned, 0.5));
  ASSERT_TRUE(sheet) << "a wall of 1 mm, between samples that are half a second apart";
  EXPECT_EQ(sheet->bodies.second, "sheet");

  room.obstacles = {{"block", RoomBox{{6.0, 6.0, 6.0}, Isometry3d::Identity()}}};
  EXPECT_EQ(clearanceOf("", room).nearest(home).distance, 0.0) << "wholly inside";
}

TEST(Clearance, TellsWhereTheTwoAreNearest) {
  const VectorXd home = panda().homePosture();
  Room room;
  Isometry3d X_BO = Isometry3d::Identity();
  X_BO.translation() = Vector3d(0.31, 0.35, 0.5);
  room.obstacles.push_back({"rack", RoomBox{{0.3, 0.1, 0.6}, X_BO}});
  for (const Room& around : {room, withTable(0.0), withTable(0.1), withTable(0.6)}) {
    const Clearance clearance = clearanceOf("box:0.06,0.06,0.16@0,0,0.08", around);
    const Nearest nearest = clearance.nearest(home);
    if (nearest.distance > 0.0) {
      EXPECT_NEAR((nearest.onFirst - nearest.onSecond).norm(), nearest.distance, 1e-3) << nearest.second;
    }
    EXPECT_EQ(nearest.tooNear(), nearest.distance <= nearest.margin);
    // One hull a link that looks like something, and the tool's.
    std::vector<int> links;
    for (const HullSurface& hull : clearance.hulls()) {
      EXPECT_GE(hull.triangles.size(), 4u);
      links.push_back(hull.link);
    }
    EXPECT_THAT(links, testing::Contains(*panda().findLink("panda_link8")));
    EXPECT_THAT(links, testing::Contains(*panda().findLink("panda_link4")));
  }
}

// Against 400 looks along each motion: none that these see is missed, and each that is told is one.
TEST(Clearance, AgreesWithADenseSamplingOfRandomMotions) {
  Room room = withTable(-0.1);
  Isometry3d X_BO = Isometry3d::Identity();
  X_BO.translation() = Vector3d(0.5, 0.4, 0.4);
  room.obstacles.push_back({"rack", RoomBox{{0.1, 0.3, 0.8}, X_BO}});
  const Clearance clearance = clearanceOf("box:0.06,0.06,0.16@0,0,0.08", room);
  int conflicts = 0;
  VectorXd q, dq, ddq;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    // Small motions about the home posture, so that many are free.
    JointMotion motion = test::randomMotion(panda(), seed, 3, 1.0);
    const double share = 0.05 + 0.35 * (seed % 10) / 10.0;
    motion.q = (share * motion.q).rowwise() + ((1.0 - share) * panda().homePosture()).transpose();
    const auto found = clearance.firstConflict(motion);
    if (found) {
      ++conflicts;
      motion.at(found->time, q, dq, ddq);
      EXPECT_LE(clearance.nearest(q).distance, clearance.nearest(q).margin + 1e-9) << seed;
    }
    // Up to the moment that is told, to the millimetre that the course is told to.
    const double until = found ? found->time : motion.duration();
    const double step = until / (seed % 20 == 0 ? 400.0 : 20.0);
    for (double t = 0.0; t < until; t += step) {
      motion.at(t, q, dq, ddq);
      const Nearest nearest = clearance.nearest(q);
      ASSERT_GT(nearest.distance, nearest.margin - 0.001) << "seed " << seed << " at " << t << " s";
    }
  }
  EXPECT_GT(conflicts, 150);
  EXPECT_LT(conflicts, 850);
}

}  // namespace
}  // namespace heft
