#include "core/segmentation/sensor_trouble.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/recording/replayed.h"
#include "core/segmentation/flat_tops.h"
#include "core/segmentation/segmentation.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

Recording aRecording(std::uint64_t seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  SimulateOptions options;
  options.motion = MotionKind::excitation;
  options.seed = seed;
  options.duration = 8.0;
  return simulate(RobotModel::panda(), test::randomTool(random).payload, options)->recording;
}

/// Cuts a channel off so that `share` of its rows are lost at either end.
void cutBothEnds(Recording& recording, Eigen::Index channel, double share) {
  std::vector<double> values(recording.wrench.col(channel).begin(), recording.wrench.col(channel).end());
  std::sort(values.begin(), values.end());
  const auto at = [&](double p) {
    return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1))];
  };
  recording.wrench.col(channel) = recording.wrench.col(channel).cwiseMax(at(share)).cwiseMin(at(1.0 - share)).eval();
}

double troubled(const Recording& recording, SegmentMode mode) {
  const auto motion = motionOf(recording, &RobotModel::panda(), {});
  const auto labels = segmentRows(recording, rowsOf(*motion, 50.0), mode).labels;
  return static_cast<double>(std::count(labels.begin(), labels.end(), MarkLabel::ignore)) /
         static_cast<double>(labels.size());
}

TEST(SensorTrouble, BothEndsOfTwoChannelsAreSeen) {
  for (const double share : {0.03, 0.1, 0.2}) {
    Recording recording = aRecording(31);
    cutBothEnds(recording, 1, share);
    cutBothEnds(recording, 4, 0.5 * share);
    const auto tops = flatTops(recording.wrench);
    ASSERT_EQ(tops.size(), 4u) << share;
    EXPECT_EQ(std::count_if(tops.begin(), tops.end(), [](const FlatTop& top) { return top.channel == 1; }), 2);
    EXPECT_GT(troubled(recording, SegmentMode::automatic), 1.5 * share);
  }
  EXPECT_TRUE(flatTops(aRecording(31).wrench).empty());
}

TEST(SensorTrouble, WhatStandsStillOrIsMissingIsLeftOutAndCanBeTakenBack) {
  const Recording whole = aRecording(32);
  Recording alone = whole, hung = whole, gap = whole;
  alone.wrench.col(3).segment(3000, 1000).setConstant(whole.wrench(3000, 3));
  for (Eigen::Index i = 3000; i < 4000; ++i) hung.q.row(i) = whole.q.row(3000);
  gap.time.tail(5000).array() += 0.05;
  EXPECT_DOUBLE_EQ(troubled(whole, SegmentMode::automatic), 0.0);
  EXPECT_NEAR(troubled(alone, SegmentMode::automatic), 0.125, 0.02);
  // The posture stops and leaps: what filters make of that is left out as well.
  EXPECT_NEAR(troubled(hung, SegmentMode::automatic), 2.4 / 8.0, 0.02);
  for (Recording* recording : {&alone, &hung}) {
    recording->meta.marks = {{2.0, 5.0, MarkLabel::free}};
    EXPECT_DOUBLE_EQ(troubled(*recording, SegmentMode::automatic), 0.0);
  }
  EXPECT_NEAR(troubled(gap, SegmentMode::automatic), 0.05 / 8.05, 0.006);
  EXPECT_GT(troubled(gap, SegmentMode::automatic), 0.0);
  EXPECT_DOUBLE_EQ(troubled(gap, SegmentMode::all), 0.0);
}

TEST(SensorTrouble, WhatWasLoggedTwiceCountsOnce) {
  const Recording whole = aRecording(39);
  const Eigen::Index rows = whole.rows();
  EXPECT_DOUBLE_EQ(troubled(whole, SegmentMode::automatic), 0.0);
  Recording half = whole, second = whole, toggling = whole;
  half.wrench.bottomRows(rows / 2) = whole.wrench.topRows(rows / 2);
  EXPECT_NEAR(troubled(half, SegmentMode::automatic), 0.5, 0.01);
  second.wrench.middleRows(6000, 1000) = whole.wrench.middleRows(1500, 1000);
  const auto found = replayedStretches(second.wrench, 50);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].at.from, 6000);
  EXPECT_EQ(found[0].at.to, 7000);
  EXPECT_EQ(found[0].from, 1500);
  for (Eigen::Index k = 0; k < rows; ++k)
    for (Eigen::Index c = 0; c < 6; ++c) toggling.wrench(k, c) = k / 3 % 2 == 0 ? 1.0 : 2.0;
  EXPECT_TRUE(replayedStretches(toggling.wrench, 20).empty());
}

TEST(SensorTrouble, ACoarseChannelIsFrozenOnlyWhereItLeaps) {
  double left = 0.0;
  for (const std::uint64_t seed : {32u, 35u, 37u, 38u}) {
    Recording coarse = aRecording(seed);
    for (Eigen::Index c = 0; c < 6; ++c)
      coarse.wrench.col(c) = (coarse.wrench.col(c) / (c < 3 ? 1.0 : 0.1)).array().round() * (c < 3 ? 1.0 : 0.1);
    left += troubled(coarse, SegmentMode::automatic);
    Recording frozen = aRecording(seed);  // Others go on
    frozen.wrench.col(0) = coarse.wrench.col(0);
    Eigen::Index last = 5000;  // From where it leaps
    while (std::abs(coarse.wrench(last, 0) - coarse.wrench(3000, 0)) < 2.5) ++last;
    frozen.wrench.col(0).segment(3000, last - 3000).setConstant(coarse.wrench(3000, 0));
    EXPECT_GE(troubled(frozen, SegmentMode::automatic), static_cast<double>(last - 3000) / 8000.0 - 0.01) << seed;
  }
  EXPECT_DOUBLE_EQ(left, 0.0);
}

TEST(SensorTrouble, WhatIsLeftBesideALeapIsTheArmsMotion) {
  const Recording whole = aRecording(36);
  Recording hung = whole;
  for (Eigen::Index i = 3000; i < 4000; ++i) hung.q.row(i) = whole.q.row(3000);
  for (Eigen::Index i = 3000; i < 4000; ++i) hung.dq.row(i).setZero();
  for (const double cutoff : {25.0, 12.0}) {
    MotionOptions options;
    options.cutoffHz = cutoff;
    const Motion is = motionOf(hung, &RobotModel::panda(), options).value(),
                 was = motionOf(whole, &RobotModel::panda(), options).value();
    const WrenchRows rows = rowsOf(is, 50.0), before = rowsOf(was, 50.0);
    const auto labels = segmentRows(hung, rows, SegmentMode::automatic).labels;
    double left = 0.0, all = 0.0;
    for (std::size_t k = 0; k < labels.size(); ++k) {
      const double off = (rows.Y[k] - before.Y[k]).cwiseAbs().maxCoeff();
      all = std::max(all, off);
      if (labels[k] != MarkLabel::ignore) left = std::max(left, off);
    }
    EXPECT_GT(all, 10.0) << cutoff;  // [m/s2, rad/s2]
    EXPECT_LT(left, 0.1) << cutoff;
  }
}

TEST(SensorTrouble, ALeapOfThePostureIsLeftOutAndCanBeTakenBack) {
  Recording recording = aRecording(34);
  const Eigen::Index half = recording.rows() / 2;
  recording.q.bottomRows(half) = recording.q.middleRows(300, half).eval();
  EXPECT_NEAR(troubled(recording, SegmentMode::automatic), 1.4 / 8.0, 0.02);
  recording.meta.marks = {{2.0, 6.0, MarkLabel::free}};
  EXPECT_DOUBLE_EQ(troubled(recording, SegmentMode::automatic), 0.0);
}

TEST(SensorTrouble, WhatTheUserMarkedFreeIsNotSaidToBeExcluded) {
  Recording recording = aRecording(32);
  recording.wrench.col(3).segment(3000, 1000).setConstant(recording.wrench(3000, 3));  // 3 to 4 s
  const auto motion = motionOf(recording, &RobotModel::panda(), {});
  const auto said = [&](double from, double to) {
    recording.meta.marks = {{from, to, MarkLabel::free}};
    std::string all;
    for (const auto& finding : segmentRows(recording, rowsOf(*motion, 50.0), SegmentMode::automatic).findings)
      if (finding.code == "sensor_trouble") all += finding.text.substr(0, 14) + "|" + finding.remedy + "\n";
    return all;
  };
  EXPECT_EQ(said(0.0, 1.0), "3.00 to 4.00 s|It is excluded; mark it as free to use it.\n");
  EXPECT_EQ(said(2.5, 4.5), "3.00 to 4.00 s|It is used, since it is marked as free.\n");
  const std::string both = said(3.5, 4.5);
  EXPECT_NE(both.find("3.00 to 3.50 s|It is excluded; "), std::string::npos) << both;
  EXPECT_NE(both.find("3.50 to 4.00 s|It is used, "), std::string::npos) << both;
}

TEST(SensorTrouble, AChannelThatIsMostlyCutOffIsNamed) {
  Recording recording = aRecording(33);
  cutBothEnds(recording, 5, 0.3);
  const auto cut = mostlyCutOff(flatTops(recording.wrench), recording.rows());
  EXPECT_TRUE(cut[5]);
  EXPECT_EQ(std::count(cut.begin(), cut.end(), true), 1);
}

}  // namespace
}  // namespace heft
