#include "core/recording/clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace heft {
namespace {

TEST(SequenceClock, TakesTheNetworksJitterOut) {
  SequenceClock clock;
  std::mt19937 random(1);
  std::exponential_distribution<double> jitter(1.0 / 0.002);
  double worst = 0.0;
  double before = -1.0;
  for (int k = 0; k < 7000; ++k) {
    const double truth = 0.001 * k;
    const double time = clock.timeOf(k, truth + jitter(random));
    EXPECT_GT(time, before);
    before = time;
    if (k > 2000) worst = std::max(worst, std::abs(time - truth - 0.002));
  }
  EXPECT_LT(worst, 0.001);  // single arrivals are up to 15 ms late
}

TEST(SequenceClock, KnowsTheStepsAfterAHundred) {
  std::mt19937 random(3);
  std::normal_distribution<double> jitter(0.0, 5e-4);
  for (int again = 0; again < 20; ++again) {
    SequenceClock clock;
    double before = 0.0;
    for (int k = 0; k < 200; ++k) {
      const double time = clock.timeOf(k, 0.004 * k + jitter(random));
      if (k > 100) {
        EXPECT_NEAR(time, 0.004 * k, 5e-4);
        EXPECT_NEAR(time - before, 0.004, 8e-5);
      }
      before = time;
    }
  }
}

TEST(SequenceClock, GoesOnOverLossesAndStartsAnewAfterAPause) {
  SequenceClock clock;
  for (int k = 0; k < 1000; ++k) clock.timeOf(k, 0.001 * k);
  EXPECT_NEAR(clock.timeOf(1500, 1.5), 1.5, 0.002);
  EXPECT_NEAR(clock.timeOf(1501, 9.0), 9.0, 1e-9);
}

TEST(StampClock, AddsTheLeastDelay) {
  StampClock clock;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> delay(0.001, 0.02);
  for (int k = 0; k < 10; ++k)
    EXPECT_TRUE(std::isnan(clock.timeOf(0.01 * k, 1000.0 + 0.01 * k + (k == 4 ? 0.001 : delay(random)))));
  for (int k = 10; k < 100; ++k)
    EXPECT_NEAR(clock.timeOf(0.01 * k, 1000.0 + 0.01 * k + delay(random)), 1000.001 + 0.01 * k, 1e-9);
}

/// The sender's clock is set, by an hour forward or back: a few messages teach the delay anew, times go on.
TEST(StampClock, GoesOnWhereTheSendersClockIsSet) {
  for (const double jump : {3600.0, -3600.0}) {
    StampClock clock;
    double last = 0.0;
    int learning = 0;
    for (int k = 0; k < 200; ++k) {
      const double arrival = 1000.0 + 0.01 * k + 0.002, stamp = 0.01 * k + (k >= 100 ? jump : 0.0);
      const double time = clock.timeOf(stamp, arrival);
      if (std::isnan(time)) {
        ++learning;
        continue;
      }
      EXPECT_NEAR(time, arrival, 1e-6) << jump << " " << k;
      EXPECT_GT(time, last);
      last = time;
    }
    EXPECT_EQ(learning, 20);
  }
}

}  // namespace
}  // namespace heft
