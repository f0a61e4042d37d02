// A zero that walks at random against one that swings.
#include "core/diagnosis/wandering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/simulation/random.h"

namespace heft::test {
namespace {

using namespace diagnosis;

/// 20 s at 50 Hz: noise of 0.02, a walk of `walk` per root second, a wave of `wave` at 0.3 Hz on one channel.
double judged(std::uint64_t seed, double walk, double wave) {
  Signals signals;
  signals.rateHz = 200.0;
  signals.samplesPerBlock = 4;
  signals.measured = Wrenches::Zero(6, 1000);
  signals.kinematics.omega.setZero(3, 4000);
  Wrenches residual(6, 1000);
  for (Eigen::Index c = 0; c < 6; ++c) {
    RandomStream random(seed, RandomPurpose::walk, static_cast<std::uint64_t>(c));
    double zero = 0.0;
    for (Eigen::Index n = 0; n < 1000; ++n) {
      zero += walk * random.normal() / std::sqrt(50.0);
      const double swing = c == 1 ? wave * std::sin(2.0 * std::numbers::pi * 0.3 * signals.blockTime(n)) : 0.0;
      residual(c, n) = zero + swing + 0.02 * random.normal();
    }
  }
  return slowWave(signals, {{20, 400}, {460, 980}}, residual);
}

TEST(SlowWave, NoWalkLooksLikeOne) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
    for (const double walk : {0.0, 0.01, 0.1}) EXPECT_LT(judged(seed, walk, 0.0), 1.0) << seed << " " << walk;
}

TEST(SlowWave, IsSeenAboveTheWalk) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) EXPECT_GT(judged(seed, 0.01, 0.2), 1.0) << seed;
}

}  // namespace
}  // namespace heft::test
