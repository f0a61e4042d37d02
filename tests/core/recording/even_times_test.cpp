#include "core/recording/even_times.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace heft {
namespace {

constexpr double kStep = 0.004;

/// Times between the samples whose stamps `stamp` gives; one it calls NaN was lost.
template <class Stamp>
StampScatter scatterOf(Stamp stamp, int count = 1001) {
  std::vector<double> steps;
  double last = NAN;
  for (int k = 0; k < count; ++k) {
    const double time = stamp(k, kStep * k);
    if (std::isnan(time)) continue;
    if (!std::isnan(last)) steps.push_back(std::max(1e-6, time - last));
    last = time;
  }
  return stampScatter(steps);
}

TEST(StampScatter, EvenStampsHaveNone) {
  const auto even = scatterOf([](int, double t) { return t; });
  EXPECT_LT(even.off, 1e-9);
  EXPECT_NEAR(even.step, kStep, 1e-9);
  // A clock that runs a thousandth too fast.
  EXPECT_LT(scatterOf([](int, double t) { return 1.001 * t; }).off, 1e-9);
  EXPECT_LT(scatterOf([](int, double t) { return std::round(1e6 * t) * 1e-6; }).off, 1e-6);
  EXPECT_EQ(scatterOf([](int, double t) { return t; }, 150).off, 0.0) << "too few to tell";
}

TEST(StampScatter, JitterIsMeasured) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.0, 5e-4);
  EXPECT_NEAR(scatterOf([&](int, double t) { return t + normal(random); }).off, 5e-4, 5e-5);
}

TEST(StampScatter, SoIsWhatComesAndGoesSlowly) {
  // Steps differ by a fifth at most, and the stamps are off by 7 ms.
  const auto wandering = [](int, double t) { return t + 0.01 * std::sin(2.0 * std::numbers::pi * 3.0 * t); };
  EXPECT_NEAR(scatterOf(wandering).off, 0.0061, 0.0006);
}

TEST(StampScatter, BurstsAreNoEvenSteps) {
  for (const int burst : {2, 5, 20}) {
    const auto scatter = scatterOf([burst](int k, double) { return kStep * burst * (k / burst) + 1e-6 * (k % burst); });
    EXPECT_NEAR(scatter.step, kStep, 0.05 * kStep) << burst;
    EXPECT_GT(scatter.off, 0.14 * kStep * burst) << burst;
  }
}

TEST(StampScatter, LostLateAndPausedIsNoScatter) {
  std::mt19937 random(6);
  EXPECT_LT(scatterOf([&](int, double t) { return random() % 10 == 0 ? NAN : t; }).off, 1e-9);
  EXPECT_LT(scatterOf([&](int k, double t) { return t + (k % 50 == 30 ? 0.003 : 0.0); }).off, 1e-4);
  // Two late in a row, between lost ones.
  EXPECT_LT(scatterOf([&](int k, double t) { return k % 90 == 7 ? NAN : t + (k % 50 < 2 ? 0.003 : 0.0); }).off, 1e-4);
  EXPECT_LT(scatterOf([](int k, double t) { return t + (k > 500 ? 2.0 : 0.0); }).off, 1e-9);
}

/// 8 s at 250 Hz of an arm that moves; `measured` and `stamped` [s] of row k.
template <class Measured, class Stamped>
Recording movedAt(Measured measured, Stamped stamped) {
  Recording out;
  out.time.resize(2000);
  out.q.resize(2000, 7);
  for (int k = 0; k < 2000; ++k) {
    const double t = measured(k);
    out.time(k) = stamped(k, t);
    for (int j = 0; j < 7; ++j) out.q(k, j) = 0.3 * std::sin((2.0 + j) * t);
  }
  return out;
}

TEST(EvenTimes, AreFoundUnderJitter) {
  for (const double jitter : {2e-4, 1e-3}) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0.0, jitter);
    StampScatter scatter;
    const auto even = evenTimes(movedAt([](int k) { return kStep * k; },
                                        [&](int, double t) { return t + std::clamp(normal(random), -1.9e-3, 1.9e-3); }),
                                scatter);
    ASSERT_TRUE(even) << jitter;
    EXPECT_NEAR(scatter.off, jitter, 0.1 * jitter);
    EXPECT_NEAR(scatter.step, kStep, 1e-6);
    for (int k = 0; k < 2000; ++k) EXPECT_NEAR((*even)(k), kStep * k, 0.15 * jitter);
  }
}

TEST(EvenTimes, AreNoneWhereTheStampsAreRight) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal(0.0, 5e-4);
  StampScatter scatter;
  const auto asMeasured = [](int, double t) { return t; };
  EXPECT_FALSE(evenTimes(movedAt([](int k) { return kStep * k; }, asMeasured), scatter));
  EXPECT_FALSE(evenTimes(movedAt([&](int k) { return kStep * k + normal(random); }, asMeasured), scatter));
  // Rows that were lost, and a pause.
  int lost = 0;
  EXPECT_FALSE(evenTimes(movedAt([&](int k) { return kStep * (k + (lost += random() % 10 == 0 ? 1 : 0)); }, asMeasured),
                         scatter));
  EXPECT_FALSE(evenTimes(movedAt([](int k) { return kStep * k + (k > 900 ? 3.0 : 0.0); }, asMeasured), scatter));
}

TEST(EvenTimes, APauseIsNoStepAndLostRowsKeepTheirStamps) {
  for (const bool loses : {false, true}) {
    std::mt19937 random(9);
    std::normal_distribution<double> normal(0.0, 3e-4);
    int lost = 0;
    std::vector<double> truth;
    StampScatter scatter;
    const auto measured = [&](int k) {
      lost += loses && random() % 20 == 0 ? 1 : 0;
      truth.push_back(kStep * (k + lost) + (k > 1100 ? 2.5 : 0.0));
      return truth.back();
    };
    const auto even = evenTimes(movedAt(measured, [&](int, double t) { return t + normal(random); }), scatter);
    ASSERT_EQ(even.has_value(), !loses);
    for (int k = 0; k < 2000 && even; ++k) EXPECT_NEAR((*even)(k), truth[static_cast<std::size_t>(k)], 1e-4) << k;
  }
}

}  // namespace
}  // namespace heft
