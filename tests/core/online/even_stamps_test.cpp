#include "core/online/even_stamps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace heft {
namespace {

constexpr double kEvenStep = 0.004;  // [s]

VectorXd armAt(double t) {
  VectorXd q(7);
  for (Eigen::Index j = 0; j < 7; ++j) q(j) = 0.3 * std::sin((2.0 + static_cast<double>(j)) * t);
  return q;
}

TEST(EvenStamps, JitterOfAnEvenSourceIsTakenOut) {
  std::mt19937 random(1);
  std::normal_distribution<double> jitter(0.0, 5e-4);
  EvenStamps stamps;
  double square = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const double t = kEvenStep * k, time = stamps.timeOf(t + jitter(random), armAt(t));
    if (k >= 1000) square += (time - t) * (time - t) / 1000.0;
  }
  EXPECT_TRUE(stamps.used());
  EXPECT_LT(std::sqrt(square), 1e-4);
}

TEST(EvenStamps, TheFirstOnesAreCorrectedTogether) {
  std::mt19937 random(2);
  std::normal_distribution<double> jitter(0.0, 5e-4);
  EvenStamps stamps;
  for (int k = 0; k < 99; ++k) {
    EXPECT_TRUE(stamps.corrected().empty());
    stamps.timeOf(kEvenStep * k + jitter(random), armAt(kEvenStep * k));
  }
  stamps.timeOf(kEvenStep * 99, armAt(kEvenStep * 99));
  const auto corrected = stamps.corrected();
  ASSERT_EQ(corrected.size(), 100u);
  for (std::size_t i = 30; i < 100; ++i) EXPECT_NEAR(corrected[i], kEvenStep * static_cast<double>(i), 4e-4);
}

TEST(EvenStamps, WhatWasMeasuredAtUnevenTimesKeepsThem) {
  std::mt19937 random(3);
  std::normal_distribution<double> jitter(0.0, 5e-4);
  EvenStamps stamps;
  for (int k = 0; k < 1000; ++k) {
    const double t = kEvenStep * k + jitter(random);
    ASSERT_EQ(stamps.timeOf(t, armAt(t)), t);
  }
}

TEST(EvenStamps, EvenOnesAndAnArmAtRestAreLeftAlone) {
  std::mt19937 random(4);
  std::normal_distribution<double> jitter(0.0, 5e-4), noise(0.0, 1e-5);
  EvenStamps even, still;
  for (int k = 0; k < 1000; ++k) {
    ASSERT_EQ(even.timeOf(kEvenStep * k, armAt(kEvenStep * k)), kEvenStep * k);
    const double t = kEvenStep * k + jitter(random);
    VectorXd rest = armAt(1.0);
    for (double& q : rest) q += noise(random);
    ASSERT_EQ(still.timeOf(t, rest), t);
  }
}

/// Some are lost, one in fifty comes two milliseconds late.
TEST(EvenStamps, LostAndLateOnesDoNotLeadItAstray) {
  std::mt19937 random(5);
  std::normal_distribution<double> jitter(0.0, 3e-4);
  EvenStamps stamps;
  double square = 0.0;
  int count = 0;
  for (int k = 0; k < 4000; ++k) {
    const double t = kEvenStep * k, late = random() % 50 == 0 ? 2e-3 : 0.0, stamp = t + late + jitter(random);
    if (random() % 40 == 0) continue;
    const double time = stamps.timeOf(stamp, armAt(t));
    if (k < 1000) continue;
    square += (time - t) * (time - t);
    ++count;
  }
  EXPECT_TRUE(stamps.used());
  EXPECT_LT(std::sqrt(square / count), 3e-4);
}

}  // namespace
}  // namespace heft
