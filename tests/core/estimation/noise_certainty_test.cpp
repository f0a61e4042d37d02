#include "core/estimation/noise_certainty.h"

#include <gtest/gtest.h>

#include <random>

#include "core/estimation/fit_rows.h"
#include "core/math/linear_algebra.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

using Loads = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Rows of a guided motion, 50 a second, with white noise and noise that forgets by `memory` a row in every channel:
/// standard deviations of the forces [N], of the torques a twentieth [N m].
WrenchRows guidedRows(std::mt19937& random, const Vector10d& phi, int n, double white, double slow, double memory) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0.0, 6.28);
  const Vector3d at{phase(random), phase(random), phase(random)};
  WrenchRows rows;
  rows.rateHz = 50.0;
  rows.wrench.resize(6, n);
  Vector6d state;
  for (auto& value : state) value = normal(random);
  for (int k = 0; k < n; ++k) {
    const double t = k / 50.0;
    const auto turn = [&](double speed, int axis) { return std::sin(speed * t + at(axis)); };
    rows.Y.push_back(regressor({rotationFromVector({turn(2.0, 0), turn(1.4, 1), t}) * Vector3d(0, 0, 9.81),
                                {turn(2.0, 1), turn(3.0, 2), turn(1.0, 0)},
                                {6 * turn(6, 0), 8 * turn(8, 1), 5 * turn(10, 2)}}));
    for (int c = 0; c < 6; ++c) {
      state(c) = memory * state(c) + std::sqrt(1.0 - memory * memory) * normal(random);
      const double unit = c < 3 ? 1.0 : 0.05;
      rows.wrench(c, k) = unit * (white * normal(random) + slow * state(c));
    }
    rows.wrench.col(k) += rows.Y.back() * phi;
  }
  return rows;
}

TEST(NoiseCertainty, SlowNoiseUnderALoudWhiteOneIsFound) {
  // Slow noise of a sixth of the white one's size makes 2.1 times its power below the memory's corner of 0.3 Hz, and
  // 1.5 times in the windows; an autoregressive model of white noise knows nothing of it.
  std::mt19937 random(11);
  double found = 0.0;
  const int trials = 20;
  for (int trial = 0; trial < trials; ++trial) {
    const WrenchRows rows = guidedRows(random, Vector10d::Zero(), 1000, 0.2, 0.2 / 6.0, 0.9);
    NoiseModel white;
    Vector6d whitener;
    for (std::size_t c = 0; c < 6; ++c) {
      white.channels[c].sigma = c < 3 ? 0.2 : 0.01;
      whitener(static_cast<Eigen::Index>(c)) = 1.0 / white.channels[c].sigma;
    }
    white.whitener = whitener.asDiagonal();
    const NoiseModel scaled = scaledToSlowNoise(white, rows, Loads::Ones(6, 1000), {{0, 1000}}, {});
    found += std::pow(scaled.channels[0].sigma / 0.2, 2) / trials;
    EXPECT_NEAR(scaled.whitener(0, 0) * scaled.channels[0].sigma, 1.0, 1e-12);
  }
  // Variance of a mean of ten: 1 + (1/36) (1 + 2 sum_1^9 (1 - i/10) 0.9^i)
  double expected = 1.0 + 1.0 / 36.0;
  for (int i = 1; i < 10; ++i) expected += 2.0 / 36.0 * (1.0 - i / 10.0) * std::pow(0.9, i);
  EXPECT_NEAR(found, expected, 0.05);
}

TEST(NoiseCertainty, NothingComesBelowTheSensorsSteps) {
  std::mt19937 random(12);
  const WrenchRows rows = guidedRows(random, Vector10d::Zero(), 300, 0.01, 0.0, 0.0);
  KnownOfNoise known;
  known.least << Vector3d::Constant(0.05), Vector3d::Constant(0.002);
  const LearnedNoise learned = withTaken(learnedNoise(rows, {{0, 300}}, known), rows, {{0, 300}}, known);
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_GE(learned.noise.channels[c].sigma * std::max(1.0, learned.noise.channels[c].gain()),
              known.least(static_cast<Eigen::Index>(c)) * (1.0 - 1e-9));
}

TEST(NoiseCertainty, LearningCostsMoreWhereRowsAreFew) {
  std::mt19937 random(13);
  const auto shortfall = [&](int n) {
    const WrenchRows rows = guidedRows(random, Vector10d::Zero(), n, 0.1, 0.1, 0.8);
    const LearnedNoise learned = withTaken(learnedNoise(rows, {{0, n}}, {}), rows, {{0, n}}, {});
    const double out = shortfallOfLearning(rows, learned.noise, {{0, n}}, {});
    EXPECT_EQ(out, shortfallOfLearning(rows, learned.noise, {{0, n}}, {}));
    return out;
  };
  const double few = shortfall(60), many = shortfall(1500);
  EXPECT_GT(few, 1.15);
  EXPECT_GT(many, 0.93);
  EXPECT_LT(many, 1.08);
}

TEST(NoiseCertainty, TheRegionOfAllTenNumbersHoldsAfterASecond) {
  std::mt19937 random(14);
  constexpr double kChiSquared95 = 18.307;  // Ten degrees of freedom
  const int trials = 80;
  int inside = 0;
  double size = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    const Vector10d phi = toParameters(test::randomPayload(random));
    const WrenchRows rows = guidedRows(random, phi, 60, 0.1, 0.1, 0.8);
    const std::vector<heft::Run> runs{{0, 60}};
    const Triangle R = fitRowsOf({rows, runs, {}, {}}).whitened;
    const MatrixXd A = R.block<11, 10>(kBiasColumns, kBiasColumns);
    const VectorXd y = R.col(kColumns).tail<11>();
    const double chiSquared = (A * phi - y).squaredNorm() - (A * leastSquares(A, y).x - y).squaredNorm();
    inside += chiSquared < kChiSquared95 ? 1 : 0;
    size += chiSquared / 10.0 / trials;
  }
  // 80 regions of 95 % hold the truth at least 70 times in 99.8 % of all sets.
  EXPECT_GE(inside, 70);
  EXPECT_GT(size, 0.4);  // Honest is not the same as wide.
}

}  // namespace
}  // namespace heft
