#include "core/estimation/fit_rows.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "core/motion/motion_noise.h"
#include "tests/support/coverage.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

/// What a payload makes of the blocks, it makes of a narrower band of them, tremor and all: nothing is left over.
TEST(FitRows, APayloadFitsEveryBandAlike) {
  std::mt19937 random(3);
  const Vector10d phi = toParameters(test::randomPayload(random));
  WrenchRows blocks;
  blocks.rateHz = 50.0;
  blocks.wrench.resize(6, 400);
  for (Eigen::Index k = 0; k < 400; ++k) {
    const double t = static_cast<double>(k) / 50.0, tremor = std::sin(2.0 * std::numbers::pi * 10.0 * t);
    blocks.Y.push_back(
        regressor({Vector3d(std::sin(t), std::cos(t), 9.0 + tremor), Vector3d(tremor, std::cos(2 * t), t),
                   Vector3d(30.0 * tremor, std::sin(3 * t), std::cos(t))}));
    blocks.wrench.col(k) = blocks.Y.back() * phi + Vector6d::Ones();
  }
  for (const int stride : {2, 4, 8}) {
    std::vector<heft::Run> runs{{10, 150}, {160, 165}, {200, 400}};
    const WrenchRows rows = narrowed(blocks, stride, runs);
    ASSERT_EQ(runs.size(), 2u) << "a run shorter than the window is dropped";
    EXPECT_EQ(runs.back().to, rows.size());
    EXPECT_DOUBLE_EQ(rows.rateHz, 50.0 / stride);
    for (Eigen::Index k = 0; k < rows.size(); ++k)
      EXPECT_LT((rows.wrench.col(k) - Vector6d::Ones() - rows.Y[static_cast<std::size_t>(k)] * phi).norm(), 1e-9);
  }
}

TEST(FitRows, MotionNoiseOfAPartStandsForTheWhole) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const Vector10d phi = toParameters(test::randomPayload(random));
  constexpr Eigen::Index kBlocks = 4000, kStretch = 200;
  WrenchRows blocks;
  blocks.rateHz = 50.0;
  blocks.wrench.resize(6, kBlocks);
  MotionNoiseRows whole{blocks, 1.0};
  for (Eigen::Index k = 0; k < kBlocks; ++k) {
    const auto any = [&](double size) {
      return Vector3d(size * Vector3d::NullaryExpr([&] { return normal(random); }));
    };
    blocks.Y.push_back(regressor({any(9.0), any(2.0), any(10.0)}));
    blocks.wrench.col(k) = blocks.Y.back() * phi + 0.1 * Vector6d::NullaryExpr([&] { return normal(random); });
    whole.rows.Y.push_back(0.02 * regressor({any(1.0), any(0.1), any(1.0)}));
  }
  whole.rows.wrench.setZero();
  MotionNoiseRows part = whole;
  part.share = 0.5;
  for (Eigen::Index k = 0; k < kBlocks; ++k)
    if (k / kStretch % 2 == 0) part.rows.Y[static_cast<std::size_t>(k)].setZero();
  const std::vector<heft::Run> runs{{0, kBlocks}};
  const Matrix10d ofWhole = fitRowsOf({blocks, runs, {}, whole}).motionNoise;
  const Matrix10d ofPart = fitRowsOf({blocks, runs, {}, part}).motionNoise;
  EXPECT_GT(ofWhole.norm(), 1.0);
  EXPECT_LT((ofPart - ofWhole).norm(), 0.1 * ofWhole.norm());
}

TEST(MotionNoise, IsToldUnderAMotion) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  constexpr double kRate = 500.0;
  MatrixXd signal(4000, 3);
  const VectorXd time = VectorXd::LinSpaced(4000, 0.0, 3999.0 / kRate);
  for (Eigen::Index k = 0; k < signal.rows(); ++k) {
    const double t = static_cast<double>(k) / kRate;
    const double motion = std::sin(2.0 * t) + 0.01 * std::sin(2.0 * std::numbers::pi * 9.0 * t);
    signal.row(k) << motion + 1e-4 * normal(random), motion + 1e-6 * normal(random), std::round(motion / 1e-4) * 1e-4;
  }
  const auto noise = whiteNoiseOf(gridFor(time), time, signal);
  ASSERT_TRUE(noise.has_value());
  EXPECT_NEAR((*noise)(0), 1e-4, 1.5e-5);
  EXPECT_NEAR((*noise)(1), 1e-6, 3e-7);
  EXPECT_NEAR((*noise)(2), 1e-4 / std::sqrt(12.0), 1e-5) << "steps are noise of their size over root twelve";
  EXPECT_FALSE(whiteNoiseOf(gridFor(kRate / 60.0 * time), kRate / 60.0 * time, signal).has_value())
      << "too slow to tell";
}

/// A small set of the benchmark interval_study, fixed seed. 48 recordings: 0.95 less four standard deviations of chance
/// is 0.83 for a mass.
TEST(FitRows, IntervalsHoldWithNoisyAndCoarseEncoders) {
  struct Case {
    double noise, step, duration;
  };
  for (const Case& c : {Case{1e-4, 0.0, 10.0}, Case{0.0, 1e-4, 5.0}, Case{1e-5, 0.0, 3.0}}) {
    std::vector<test::CoverageOptions> kinds(2);
    kinds[1].motion = MotionKind::excitation;
    for (auto& kind : kinds) {
      kind.recordings = 24;
      kind.seed = 77;
      kind.duration = c.duration;
      kind.jointNoise = c.noise;
      kind.jointStep = c.step;
      kind.velocities = false;
    }
    const auto result = test::measureCoverage(kinds, 2);
    EXPECT_EQ(result.failed, 0);
    EXPECT_GE(result.mass.inside, 0.83) << c.noise << " " << c.step;
    EXPECT_GE(result.com.inside, 0.86) << c.noise << " " << c.step;
    EXPECT_GE(result.inertia.inside, 0.86) << c.noise << " " << c.step;
    EXPECT_EQ(result.beyond5, 0) << c.noise << " " << c.step;
    EXPECT_GT(result.inertia.ratio, 0.6) << "honest is not the same as wide";
  }
}

}  // namespace
}  // namespace heft
