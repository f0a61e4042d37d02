// The bound on how far a joint travels, and a body with it, is kept between the samples.
#include "core/collision/course.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/collision/random_motion.h"

namespace heft {
namespace {

TEST(Course, NoPointMovesFartherThanItSays) {
  const RobotModel& robot = RobotModel::panda();
  const int flange = *robot.findLink("panda_link8");
  const Vector3d point(0.05, -0.02, 0.15);
  const VectorXd reach = jointReach(robot, flange, point);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const JointMotion motion = test::randomMotion(robot, seed, 5, 1.0);
    const Course course(motion);
    const VectorXd moved = course.movedBy(reach);
    VectorXd q;
    for (double t = 0.0; t < motion.duration(); t += 0.37) {
      constexpr double kFar = 0.08;
      const double until = std::min(course.untilMoved(moved, t, kFar), motion.duration());
      EXPECT_GT(until, t);
      course.at(t, q);
      const Vector3d from = robot.linkPose(q, flange) * point;
      double farthest = 0.0;
      for (int i = 1; i <= 50; ++i) {
        course.at(t + (until - t) * i / 50.0, q);
        farthest = std::max(farthest, (robot.linkPose(q, flange) * point - from).norm());
      }
      EXPECT_LE(farthest, kFar + 1e-9) << "seed " << seed << " at " << t;
    }
  }
}

TEST(Course, JointsBelowTwoLinksMoveNeitherAgainstTheOther) {
  const RobotModel& robot = RobotModel::panda();
  const auto shared = sharedJoints(robot, *robot.findLink("panda_link3"), *robot.findLink("panda_link6"));
  for (std::size_t j = 0; j < shared.size(); ++j) EXPECT_EQ(shared[j], j < 3) << j;
  EXPECT_EQ(jointReach(robot, *robot.findLink("panda_link3"), Vector3d::Zero())(5), 0.0);
}

TEST(Course, TheFirstLinkOfAnArmOnATableStaysAsHighAsItIs) {
  const RobotModel& robot = RobotModel::panda();
  const int first = *robot.findLink("panda_link1"), second = *robot.findLink("panda_link2");
  EXPECT_FALSE(changesHeight(robot, first, Vector3d::UnitZ()));
  EXPECT_FALSE(changesHeight(robot, first, -Vector3d::UnitZ()));
  EXPECT_TRUE(changesHeight(robot, first, Vector3d::UnitX()));
  EXPECT_TRUE(changesHeight(robot, first, Vector3d(0.0, 0.01, 1.0).normalized()));
  EXPECT_TRUE(changesHeight(robot, second, Vector3d::UnitZ()));
}

}  // namespace
}  // namespace heft
