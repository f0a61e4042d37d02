#include "core/coach/excitation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/core/coach/perform.h"

namespace heft {
namespace {

struct Taught {
  Recording recording;
  GuidedTool tool;
  OnlineInformation information;
  std::vector<Segment> segments;
};

const Taught& taught() {
  static const Taught instance = [] {
    Taught t;
    t.recording = test::simulated(MotionKind::free, test::onlineTool(), 5, 10.0, 0.3);
    t.tool = *guidedTool(RobotModel::panda(), t.recording.meta.mount);
    t.information = *informationOf(t.recording, &RobotModel::panda(), {});
    t.segments = {
        {0.0, 4.0, MarkLabel::free, ""}, {4.0, 6.0, MarkLabel::contact, ""}, {6.0, 10.0, MarkLabel::free, ""}};
    return t;
  }();
  return instance;
}

TEST(Excitation, IsSmallInsideAllLimitsAndOnlyInFreeParts) {
  const Taught& t = taught();
  const auto excited = excite(t.recording, t.tool, t.segments, t.information);
  ASSERT_TRUE(excited.ok()) << excited.error().message;
  EXPECT_TRUE(excited->use.kept());
  test::expectLimitsKept(excited->excited, t.tool, kTcpSpeed);
  EXPECT_LE(excited->deviation, 0.02);
  EXPECT_GT(excited->amplitude, 0.005);
  EXPECT_LE(excited->amplitude, 0.10);
  ASSERT_EQ(excited->free.size(), 2u);
  int changed = 0;
  for (Eigen::Index k = 0; k < excited->excited.size(); ++k) {
    const double time = excited->excited.time(k);
    const bool inside = std::any_of(excited->free.begin(), excited->free.end(),
                                    [&](const Segment& s) { return time > s.from && time < s.to; });
    const double off = (excited->excited.q.row(k) - excited->taught.q.row(k)).norm();
    if (!inside) {
      EXPECT_EQ(off, 0.0) << time;
    }
    changed += off > 1e-4 ? 1 : 0;
  }
  EXPECT_GT(changed, excited->excited.size() / 2);
  // At rest at both ends: a controller can start from there.
  EXPECT_LT(excited->excited.dq.row(0).norm(), 1e-9);
  EXPECT_LT(excited->excited.dq.bottomRows(1).norm(), 1e-9);
}

TEST(Excitation, PromisesMoreThanTheReplayAndKeepsThePromise) {
  const Taught& t = taught();
  const auto excited = excite(t.recording, t.tool, t.segments, t.information);
  ASSERT_TRUE(excited.ok());
  EXPECT_LT(excited->replayed.inertia, excited->now.inertia);
  EXPECT_LT(excited->after.inertia, 0.95 * excited->replayed.inertia);
  // The replay itself, by the same tool: what it alone tells cannot be as sharp as both together, but must come near.
  test::Performer arm(test::onlineTool(), 8);
  Recording replay = arm.perform(excited->excited, 0.0);
  const auto information = informationOf(replay, &RobotModel::panda(), {});
  ASSERT_TRUE(information.ok());
  const Uncertainty got = uncertaintyOf(*information);
  EXPECT_LT(got.inertia, 2.5 * excited->after.inertia);
  EXPECT_GT(got.inertia, 0.4 * excited->after.inertia);
}

TEST(Excitation, RefusesWhatTheJointsCannotHold) {
  const Taught& t = taught();
  OnlineInformation heavy = t.information;
  heavy.solution.phi = toParameters(test::boxPayload(20.0, {0.1, 0.1, 0.1}, {0.0, 0.0, 0.1}));
  const auto excited = excite(t.recording, t.tool, t.segments, heavy);
  ASSERT_FALSE(excited.ok());
  EXPECT_THAT(excited.error().message,
              testing::ContainsRegex("Joint panda_joint[0-9] would need [0-9.]+ N m of the allowed"));
  EXPECT_THAT(excited.error().message, testing::HasSubstr(" s into the motion"));
}

TEST(Excitation, FastDemonstrationsAreSlowedDown) {
  const Recording fast = test::simulated(MotionKind::free, test::onlineTool(), 6, 8.0, 1.0);
  const Taught& t = taught();
  const auto excited = excite(fast, t.tool, {{0.0, 8.0, MarkLabel::free, ""}}, t.information);
  ASSERT_TRUE(excited.ok()) << excited.error().message;
  EXPECT_GT(excited->slowed, 1.2);
  test::expectLimitsKept(excited->excited, t.tool, kTcpSpeed);
}

TEST(Excitation, SaysWhyItCannot) {
  const Taught& t = taught();
  const auto nothingFree = excite(t.recording, t.tool, {{0.0, 10.0, MarkLabel::contact, ""}}, t.information);
  ASSERT_FALSE(nothingFree.ok());
  EXPECT_THAT(nothingFree.error().message, testing::HasSubstr("free"));
  Recording poses = t.recording;
  poses.q.resize(0, 7);
  EXPECT_FALSE(excite(poses, t.tool, t.segments, t.information).ok());
}

TEST(Excitation, TrajectoryFileHasOneRowAMillisecond) {
  const std::string csv = trajectoryCsv(test::Performer::hold(RobotModel::panda().homePosture(), 0.5), 1000.0);
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "time,q1,q2,q3,q4,q5,q6,q7,dq1,dq2,dq3,dq4,dq5,dq6,dq7");
  int rows = 0;
  while (std::getline(lines, line)) ++rows;
  EXPECT_EQ(rows, 501);
}

}  // namespace
}  // namespace heft
