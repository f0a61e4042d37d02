#include "core/live/merger.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/live/session.h"

namespace heft {
namespace {

LiveSample motionAt(double t) {
  LiveSample out;
  out.time = t;
  out.q = std::array<double, 7>{t, 2.0 * t, 0, 0, 0, 0, -t};
  return out;
}
LiveSample wrenchSampleAt(double t) {
  LiveSample out;
  out.time = t;
  out.wrench = (Vector6d() << t, -t, 3.0 * t, 0.0, 1.0, t).finished();
  return out;
}

/// Parts of both streams in the order of time.
std::vector<LiveSample> merged(double motionStep, double wrenchStep, double until, StreamMerger& merger) {
  std::vector<LiveSample> out;
  double m = 0.0005;
  double w = 0.0;
  while (m < until || w < until) {
    if (m < w) {
      merger.add(motionAt(m), out);
      m += motionStep;
    } else {
      merger.add(wrenchSampleAt(w), out);
      w += wrenchStep;
    }
  }
  return out;
}

TEST(Merger, TheSlowerStreamGivesTheTimes) {
  for (const auto& [motionStep, wrenchStep] :
       {std::pair{0.01, 0.001}, std::pair{0.001, 0.01}, std::pair{0.001, 0.001}}) {
    StreamMerger merger;
    const auto out = merged(motionStep, wrenchStep, 3.0, merger);
    const double base = std::max(motionStep, wrenchStep);
    EXPECT_NEAR(static_cast<double>(out.size()), 3.0 / base, 0.05 / base);
    for (std::size_t k = 0; k < out.size(); ++k) {
      ASSERT_TRUE(out[k].q && out[k].wrench);
      ASSERT_NEAR((*out[k].q)[1], 2.0 * out[k].time, 1e-9);
      if (k > 20) {
        ASSERT_NEAR((*out[k].wrench)(0), out[k].time, 0.0006);
      }
      if (k > 0) {
        ASSERT_GT(out[k].time, out[k - 1].time);
      }
    }
    EXPECT_LT(merger.unmatched(), 5u);
  }
}

TEST(Merger, NothingIsInventedAcrossAGap) {
  StreamMerger merger;
  std::vector<LiveSample> out;
  for (int k = 0; k < 4000; ++k) {
    const double t = 0.001 * k;
    if (k < 1000 || k > 3000) merger.add(wrenchSampleAt(t), out);
    if (k % 10 == 5) merger.add(motionAt(t), out);
  }
  for (const auto& sample : out) EXPECT_TRUE(sample.time < 1.01 || sample.time > 2.99) << sample.time;
  EXPECT_GT(merger.unmatched(), 150u);
}

LiveSample feltAt(double t, double noise) {
  LiveSample out;
  out.time = t;
  out.accelerometer = Vector3d(t + noise, 2.0 * t, 9.81);
  return out;
}

/// An inertial sensor that sends five times as often is averaged; one that falls silent holds nothing up.
TEST(Merger, AnInertialSensorOfItsOwnIsJoinedIn) {
  StreamMerger merger;
  std::vector<LiveSample> out;
  for (int k = 0; k < 3000; ++k) {
    const double t = 0.001 * k;
    merger.add(wrenchSampleAt(t), out);
    if (k % 10 == 5) merger.add(motionAt(t), out);
    if (k % 2 == 0 && k < 2000) merger.add(feltAt(t, k % 4 == 0 ? 0.1 : -0.1), out);
  }
  std::size_t with = 0;
  for (const auto& sample : out) {
    with += sample.accelerometer ? 1 : 0;
    if (sample.time > 0.05 && sample.time < 1.98) {
      ASSERT_TRUE(sample.accelerometer) << sample.time;
      EXPECT_NEAR(sample.accelerometer->y(), 2.0 * sample.time, 0.005);
      EXPECT_NEAR(sample.accelerometer->x(), sample.time, 0.04) << "the mean of five, not one of them";
    }
    if (sample.time > 2.01) {
      EXPECT_FALSE(sample.accelerometer) << sample.time;
    }
  }
  EXPECT_GT(with, 190u);
  EXPECT_GT(out.size(), 295u);
  EXPECT_LT(merger.unmatched(), 5u);
}

TEST(Merger, LateAndRepeatedPartsAreCounted) {
  StreamMerger merger;
  std::vector<LiveSample> out;
  merged(0.01, 0.001, 0.5, merger);
  merger.add(wrenchSampleAt(0.3), out);
  merger.add(motionAt(0.2), out);
  EXPECT_EQ(merger.late(), 2u);
  LiveSample broken = motionAt(std::nan(""));
  merger.add(broken, out);
  EXPECT_TRUE(out.empty());
}

TEST(Merger, AnAbsentPartnerDoesNotFillTheMemory) {
  StreamMerger merger;
  std::vector<LiveSample> out;
  for (int k = 0; k < 20000; ++k) merger.add(wrenchSampleAt(0.001 * k), out);
  EXPECT_TRUE(out.empty());
  EXPECT_GT(merger.unmatched(), 17000u);
}

TEST(SampleQueue, ForgetsTheOldestWhereNobodyTakes) {
  SampleQueue queue(100);
  for (int k = 0; k < 250; ++k) queue.push(motionAt(k));
  std::vector<LiveSample> out;
  queue.takeAll(out);
  EXPECT_EQ(queue.total(), 250u);
  ASSERT_LE(out.size(), 100u);
  ASSERT_GE(out.size(), 89u);
  for (std::size_t k = 0; k < out.size(); ++k) EXPECT_EQ(out[out.size() - 1 - k].time, 249.0 - static_cast<double>(k));
  queue.push(motionAt(250));
  queue.takeAll(out);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out.front().time, 250.0);
}

}  // namespace
}  // namespace heft
