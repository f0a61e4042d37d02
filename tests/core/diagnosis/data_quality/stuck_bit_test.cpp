#include "core/diagnosis/data_quality/stuck_bit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

/// One bit of the converter stays zero: half of all readings are lower by its worth. They were spikes.
TEST(StuckBits, AreSomethingUnknown) {
  Recording recording = aRecording(MotionKind::free, 304);
  const Recording whole = recording;
  auto fy = recording.wrench.col(1);
  const double worth = 0.04 * (fy.maxCoeff() - fy.minCoeff());
  for (double& reading : fy) {
    const double steps = std::floor(reading / worth);
    if (std::fmod(std::abs(steps), 2.0) == 1.0) reading -= worth;
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "steps that a channel never reads") << said(report);
  EXPECT_EQ(named(report, "spikes"), nullptr) << said(report);
  const auto bits = diagnosis::stuckBits(recording);
  ASSERT_EQ(bits.size(), 1u);
  EXPECT_EQ(bits.front().channel, 1);
  EXPECT_NEAR(bits.front().worth, worth, 0.1 * worth);

  EXPECT_TRUE(diagnosis::stuckBits(whole).empty());
  for (Eigen::Index c = 0; c < 6; ++c) {
    const double step = 0.02 * recording.wrench.col(c).cwiseAbs().maxCoeff();
    recording.wrench.col(c) = (whole.wrench.col(c) / step).array().round().matrix() * step;
  }
  EXPECT_TRUE(diagnosis::stuckBits(recording).empty());
}

/// Where the tool seldom was, few of the steps were read: what these leave is no bit's doing.
TEST(StuckBits, LeaveGapsThroughoutTheRange) {
  constexpr double kWorth = 0.05;  // [N]
  const auto readingsWith = [&](double from, double to) {
    Recording recording;
    recording.wrench.resize(8000, 6);
    recording.wrench.rightCols(5).setZero();
    for (Eigen::Index k = 0; k < 8000; ++k) {
      const double reading = 1e-3 * static_cast<double>(k);
      const bool odd = std::fmod(std::floor(reading / kWorth), 2.0) == 1.0;
      recording.wrench(k, 0) = odd && reading >= from && reading < to ? reading - kWorth : reading;
    }
    return recording;
  };
  EXPECT_EQ(diagnosis::stuckBits(readingsWith(0.0, 8.0)).size(), 1u);
  EXPECT_TRUE(diagnosis::stuckBits(readingsWith(6.0, 7.0)).empty());
}

}  // namespace
}  // namespace heft::test
