#include "core/estimation/noise_model.h"

#include <gtest/gtest.h>

#include <random>

#include "core/estimation/triangle.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Rows of random motion with autoregressive noise of coefficient `a` in every channel.
WrenchRows noisyRows(std::mt19937& random, const Vector10d& phi, int n, double a) {
  std::normal_distribution<double> normal;
  WrenchRows rows;
  rows.rateHz = 50.0;
  rows.wrench.resize(6, n);
  Vector6d noise = Vector6d::Zero();
  for (int k = 0; k < n; ++k) {
    const double t = k / 50.0;
    const WrenchState state{rotationFromVector({std::sin(t), std::cos(0.7 * t), t}) * Vector3d(0, 0, 9.81),
                            test::randomVector(random, 0.1),
                            {std::sin(3 * t), std::cos(4 * t), std::sin(5 * t)}};
    rows.Y.push_back(regressor(state));
    for (int c = 0; c < 6; ++c) noise(c) = a * noise(c) + normal(random) * (c < 3 ? 0.02 : 0.001);
    rows.wrench.col(k) = rows.Y.back() * phi + noise;
  }
  return rows;
}

TEST(NoiseModel, LearnsColourAndScale) {
  std::mt19937 random(1);
  const WrenchRows rows = noisyRows(random, Vector10d::Zero(), 4000, 0.6);
  const std::vector<heft::Run> runs{{0, 1500}, {1600, 4000}};
  const NoiseModel noise = fitNoise(rows.wrench, Wrenches::Ones(6, 4000), runs, 0);
  EXPECT_NEAR(noise.channels[0].coefficients(0), 0.6, 0.06);
  EXPECT_NEAR(noise.channels[0].sigma, 0.02, 0.001);
  EXPECT_NEAR(noise.channels[5].sigma, 0.001, 0.00005);
  const Wrenches u = innovations(noise, rows.wrench, runs);
  EXPECT_NEAR(u.row(2).segment(10, 1490).squaredNorm() / 1490, 1.0, 0.1);
}

TEST(NoiseModel, SeesCorrelationBetweenChannels) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  Wrenches e(6, 5000);
  for (Eigen::Index k = 0; k < e.cols(); ++k) {
    for (int c = 0; c < 6; ++c) e(c, k) = normal(random);
    e(1, k) = 0.9 * e(0, k) + 0.1 * e(1, k);
  }
  const NoiseModel noise = fitNoise(e, Wrenches::Ones(6, 5000), std::vector<heft::Run>{{0, 5000}}, 0);
  const Wrenches u = innovations(noise, e, std::vector<heft::Run>{{0, 5000}});
  EXPECT_LT(std::abs(u.row(0).dot(u.row(1))) / 5000.0, 0.1);
}

TEST(NoiseModel, FoldsMergeToTheWholeProblem) {
  std::mt19937 random(3);
  const WrenchRows rows = noisyRows(random, toParameters(test::randomPayload(random)), 600, 0.5);
  const std::vector<heft::Run> runs{{0, 250}, {300, 600}};
  const NoiseModel noise = fitNoise(rows.wrench, Wrenches::Ones(6, 600), runs, 0);
  const Wrenches weights = Wrenches::Ones(6, 600);
  const Triangle whole = merged(whitenedTriangles(rows, noise, weights, runs, 1));
  const Triangle parts = merged(whitenedTriangles(rows, noise, weights, runs, 5));
  EXPECT_LT((whole.transpose() * whole - parts.transpose() * parts).norm(), 1e-9 * (whole.transpose() * whole).norm());
}

TEST(NoiseModel, BoundingShortensOnlyLongMemory) {
  NoiseModel noise;
  noise.channels[0].coefficients = VectorXd::Constant(1, 0.3);   // gain 1.4
  noise.channels[1].coefficients = VectorXd::Constant(1, 0.98);  // gain 50
  const NoiseModel out = bounded(noise);
  EXPECT_EQ(out.channels[0].coefficients(0), 0.3);
  EXPECT_NEAR(out.channels[1].gain(), kLargestGain, 1e-6);
}

TEST(NoiseModel, TheHonestTriangleIsThePlainOneWhereNothingWasBounded) {
  std::mt19937 random(4);
  const WrenchRows rows = noisyRows(random, toParameters(test::randomPayload(random)), 800, 0.4);
  const std::vector<heft::Run> runs{{0, 800}};
  const Wrenches weights = Wrenches::Ones(6, 800);
  NoiseModel noise =
      fitNoise(rows.wrench - rows.wrench.rowwise().mean() * Eigen::RowVectorXd::Ones(800), weights, runs, 0);
  for (auto& channel : noise.channels) channel.coefficients = VectorXd::Constant(1, 0.4);
  noise.order = 1;
  const Triangle plain = merged(whitenedTriangles(rows, noise, weights, runs, 1));
  const Triangle honest = honestTriangle(rows, noise, noise, weights, runs);
  const auto A = [](const Triangle& R) { return R.topLeftCorner<16, 16>(); };
  const MatrixXd Hp = A(plain).transpose() * A(plain), Hh = A(honest).transpose() * A(honest);
  EXPECT_LT((Hp - Hh).norm(), 1e-6 * Hp.norm());
  const VectorXd xp = A(plain).triangularView<Eigen::Upper>().solve(plain.col(16).head<16>());
  const VectorXd xh = A(honest).triangularView<Eigen::Upper>().solve(honest.col(16).head<16>());
  EXPECT_LT((xp - xh).norm(), 1e-6 * xp.norm());
}

TEST(NoiseModel, HonestVariancesCoverTheScatterOfABoundedFit) {
  // Noise with a memory of a second, weighted as if it had little: the plain triangle would promise too much.
  std::mt19937 random(5);
  const Vector10d phi = toParameters(test::randomPayload(random));
  double squares = 0.0, plainSquares = 0.0;
  const int trials = 60;
  for (int trial = 0; trial < trials; ++trial) {
    const WrenchRows rows = noisyRows(random, phi, 800, 0.97);
    const std::vector<heft::Run> runs{{0, 800}};
    const Wrenches weights = Wrenches::Ones(6, 800);
    NoiseModel noise;
    Vector6d whitener;
    for (std::size_t c = 0; c < 6; ++c) {
      noise.channels[c].coefficients = VectorXd::Constant(1, 0.97);
      noise.channels[c].sigma = c < 3 ? 0.02 : 0.001;
      whitener(static_cast<Eigen::Index>(c)) = 1.0 / noise.channels[c].sigma;
    }
    noise.whitener = whitener.asDiagonal();
    noise.order = 1;
    const auto ratio = [&](const Triangle& R) {
      const MatrixXd A = R.topLeftCorner<16, 16>();
      const VectorXd x = A.triangularView<Eigen::Upper>().solve(R.col(16).head<16>());
      return (x(6) - phi(0)) / std::sqrt((A.transpose() * A).inverse()(6, 6));
    };
    squares += std::pow(ratio(honestTriangle(rows, noise, bounded(noise), weights, runs)), 2) / trials;
    plainSquares += std::pow(ratio(merged(whitenedTriangles(rows, bounded(noise), weights, runs, 1))), 2) / trials;
  }
  EXPECT_NEAR(std::sqrt(squares), 1.0, 0.3);
  EXPECT_GT(std::sqrt(plainSquares), 1.5);
}

}  // namespace
}  // namespace heft
