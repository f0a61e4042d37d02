#include "core/online/convention_watch.h"

#include <gtest/gtest.h>

#include "tests/core/online/feed.h"
#include "tests/support/as_driver.h"

namespace heft {
namespace {

using test::onlineTool;
using test::simulated;

/// Feeds up to `seconds` and waits for every answer; when the first one came [s], or -1.
double firstNews(ConventionWatch& watch, const Recording& recording, double seconds) {
  double at = -1.0;
  for (Eigen::Index k = 0; k < recording.rows() && recording.time(k) < seconds; ++k) {
    watch.add(sampleOf(recording, k));
    if (watch.news(true) && at < 0.0) at = recording.time(k);
  }
  return at;
}

TEST(ConventionWatch, SaysAtOnceWhatTheNumbersMean) {
  for (const char* driver : {"base_axes", "wrench_sign", "torque_first"}) {
    Recording recording = simulated(MotionKind::free, onlineTool(), 4, 12.0);
    test::rewriteAs(driver, RobotModel::panda(), 4, recording);
    ConventionWatch watch(recording.meta, &RobotModel::panda());
    const double at = firstNews(watch, recording, 12.0);
    EXPECT_GE(at, 4.9) << driver;
    EXPECT_LE(at, 5.1) << driver;
    ASSERT_NE(watch.report(), nullptr) << driver;
    EXPECT_EQ(watch.report()->verdict, conventions::Verdict::suggested) << driver;
    EXPECT_NEAR(watch.report()->payload.mass, 0.8, 0.02 * 0.8) << driver;
  }
}

TEST(ConventionWatch, SaysNothingOfPlainNumbers) {
  for (unsigned seed = 21; seed < 25; ++seed) {
    const Recording recording = simulated(MotionKind::free, onlineTool(), seed, 20.0);
    ConventionWatch watch(recording.meta, &RobotModel::panda());
    EXPECT_LT(firstNews(watch, recording, 20.0), 0.0) << seed;
    EXPECT_EQ(watch.report(), nullptr) << seed;
  }
}

TEST(ConventionWatch, PosesDoWithoutARobotAndOrientationsAreNotAsked) {
  Recording recording = simulated(MotionKind::free, onlineTool(), 6, 8.0);
  test::rewriteAs("base_axes", RobotModel::panda(), 6, recording);
  test::logPoses(RobotModel::panda(), recording);
  ConventionWatch watch(recording.meta, nullptr);
  EXPECT_GT(firstNews(watch, recording, 8.0), 0.0);
  recording.position.resize(0, 3);
  ConventionWatch blind(recording.meta, nullptr);
  EXPECT_LT(firstNews(blind, recording, 8.0), 0.0);
}

TEST(ConventionWatch, ARecordingOfSamplesIsTheRecording) {
  const Recording recording = simulated(MotionKind::free, onlineTool(), 7, 2.0);
  std::deque<OnlineSample> samples;
  for (Eigen::Index k = 0; k < recording.rows(); ++k) samples.push_back(sampleOf(recording, k));
  const Recording again = recordingOf(samples, recording.meta, 7);
  EXPECT_EQ(again.time, recording.time);
  EXPECT_EQ(again.q, recording.q);
  EXPECT_EQ(again.wrench, recording.wrench);
}

}  // namespace
}  // namespace heft
