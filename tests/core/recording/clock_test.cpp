#include "core/live/clock.h"

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

}  // namespace
}  // namespace heft
