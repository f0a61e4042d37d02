// A zero that walks at random against one that swings, and one that drifts.
#include "core/diagnosis/search/random_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/simulation/random.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

using namespace diagnosis;

/// 20 s at 50 Hz: noise of 0.02, a walk of `walk` per root second, a wave at 0.3 Hz of `wave` on one channel, or of as
/// much altogether on all of them.
double judged(std::uint64_t seed, double walk, double wave, bool everywhere = false,
              const std::vector<Stretch>& stretches = {{20, 400}, {460, 980}}) {
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
      const double swing = (everywhere ? wave / std::sqrt(6.0)
                            : c == 1   ? wave
                                       : 0.0) *
                           std::sin(2.0 * std::numbers::pi * 0.3 * signals.blockTime(n));
      residual(c, n) = zero + swing + 0.02 * random.normal();
    }
  }
  return slowWave(signals, stretches, residual);
}

TEST(SlowWave, NoWalkLooksLikeOne) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
    for (const double walk : {0.0, 0.01, 0.1}) EXPECT_LT(judged(seed, walk, 0.0), 1.0) << seed << " " << walk;
}

/// Cosines are told apart badly where much is left out: what only that makes large is no wave.
TEST(SlowWave, IsNotWhatGapsMakeOfNoise) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
    EXPECT_LT(judged(seed, 0.0, 0.0, false, {{20, 160}, {330, 420}, {610, 680}, {850, 980}}), 1.0) << seed;
}

TEST(SlowWave, IsSeenAboveTheWalk) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (const bool everywhere : {false, true}) {
      EXPECT_GT(judged(seed, 0.01, 0.2, everywhere), 1.0) << seed << " " << everywhere;
      // Thirty deviations of the noise, which no wave of one channel shows by itself where they are spread.
      EXPECT_GT(judged(seed, 0.0, 0.03, everywhere), 1.0) << seed << " " << everywhere;
    }
}

/// Half of the time is left out, as where things are picked and placed.
TEST(SlowWave, IsSeenThroughManyGaps) {
  const std::vector<Stretch> between{{20, 140}, {240, 300}, {420, 520}, {640, 700}, {800, 980}};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_GT(judged(seed, 0.01, 0.15, false, between), 1.0) << seed;
    EXPECT_LT(judged(seed, 0.05, 0.0, false, between), 1.0) << seed;
  }
}

/// A walk of 60 draws: what its waves cost is least where the walk is as large as they are.
TEST(Walk, ThePriceIsLeastAtItsOwnSize) {
  RandomStream random(3, RandomPurpose::walk, 0);
  VectorXd waves(60), spread = VectorXd::Constant(60, 1e-6);
  for (Eigen::Index k = 0; k < 60; ++k) waves(k) = 0.5 * random.normal() / static_cast<double>(k + 1);
  const double right = complexityOfRandomWalk(waves, spread, 0.25);
  for (const double off : {0.1, 0.3, 3.0, 10.0})
    EXPECT_GT(complexityOfRandomWalk(waves, spread, 0.25 * off), right) << off;
}

/// A draught warms the sensor and goes again: it was a zero that walks, and thus clean.
TEST(Diagnose, ADriftThatAllChannelsTakeTogetherHasAnyCourse) {
  Recording recording = aRecording(MotionKind::excitation, 271);
  const Vector6d range = (Vector6d() << 0.3, -0.2, 0.15, 0.004, -0.003, 0.002).finished();
  const double T = recording.time(recording.rows() - 1);
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const double hump = std::exp(-0.5 * std::pow((recording.time(i) / T - 0.55) / 0.13, 2));
    recording.wrench.row(i) += hump * range.transpose();
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "bias_drift") << said(report);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  EXPECT_NE(cause.sentence.find("back and forth"), std::string::npos) << cause.sentence;
  const auto fx = findParameter(cause.parameters, "fx");
  ASSERT_NE(fx, nullptr) << said(report);
  EXPECT_NEAR(std::abs(fx->value), range(0), 0.05);
  // Whoever leaves it out of the catalogue does not get it by way of a walk.
  const auto without = diagnosed(recording, {"bias_drift"});
  EXPECT_EQ(named(without, "bias_drift"), nullptr) << said(without);
}

/// Six walks of about that size are none: each channel takes its own course.
TEST(Diagnose, AWalkOfEachChannelIsNoDrift) {
  for (const std::uint64_t seed : {272u, 273u, 274u}) {
    Recording recording = aRecording(MotionKind::excitation, seed);
    for (int c = 0; c < 6; ++c) {
      RandomStream random(seed, RandomPurpose::walk, static_cast<std::uint64_t>(c));
      double zero = 0.0;
      for (Eigen::Index i = 0; i < recording.rows(); ++i) {
        zero += (c < 3 ? 0.15 : 0.003) / std::sqrt(static_cast<double>(recording.rows())) * random.normal();
        recording.wrench(i, c) += zero;
      }
    }
    const auto report = diagnosed(recording);
    EXPECT_EQ(report.verdict, Verdict::clean) << seed << " " << said(report);
    EXPECT_NE(report.sentence.find("random walk"), std::string::npos) << report.sentence;
  }
}

/// A driver that compensates for temperature sets its zero anew at seven moments, by less than its noise: a walk would
/// do as well, but no walk moves at a few moments only.
/// A course that explains a little more than a straight line is too faint for a name, and the line is not.
TEST(Diagnose, AFaintDriftIsNoWalk) {
  for (const std::uint64_t seed : {316u, 323u, 330u}) {
    const auto report = diagnosed(aRecording(MotionKind::free, seed, {{"bias_drift", "", 0.13}}));
    EXPECT_NE(named(report, "bias_drift"), nullptr) << seed << ": " << said(report);
  }
}

TEST(Diagnose, AZeroThatIsSetAnewIsNoWalk) {
  Recording recording = aRecording(MotionKind::free, 131);
  RandomStream random(131, RandomPurpose::walk);
  Vector6d zero = Vector6d::Zero();
  double next = 1.2;
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    if (recording.time(i) > next) {
      next += 1.5;
      for (Eigen::Index c = 0; c < 6; ++c) zero(c) += (c < 3 ? 0.05 : 0.0025) * random.normal();
    }
    recording.wrench.row(i) += zero.transpose();
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "sudden changes") << said(report);
  EXPECT_TRUE(report.causes.empty()) << said(report);
}

/// Waves of six walks, and those of a zero that settles in all channels alike.
TEST(Walk, OneCourseOfAllChannelsIsNone) {
  Form form;
  form.walk = true;
  const auto shared = std::make_shared<const Form>(std::move(form));
  const Vector6d sizes = (Vector6d() << 0.1, 0.1, 0.1, 0.004, 0.004, 0.004).finished();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed, RandomPurpose::walk, 0);
    Term walk{shared, VectorXd(60), {}, sizes.cwiseAbs2()}, settles = walk;
    for (Eigen::Index k = 0; k < 10; ++k)
      for (Eigen::Index c = 0; c < 6; ++c) {
        const auto half = static_cast<double>(k + 1);
        const double noise = random.normal() / half;
        walk.v(6 * k + c) = sizes(c) * noise;
        settles.v(6 * k + c) = sizes(c) * ((c % 2 == 0 ? 3.0 : -2.0) / (half * half) + 0.3 * noise);
      }
    Model walks, drifts;
    walks.terms.push_back(std::move(walk));
    drifts.terms.push_back(std::move(settles));
    EXPECT_FALSE(isOneCourse(walks)) << seed;
    EXPECT_TRUE(isOneCourse(drifts)) << seed;
  }
  EXPECT_FALSE(isOneCourse(Model{}));
}

}  // namespace
}  // namespace heft::test
