#include "core/math/statistics.h"

#include <gtest/gtest.h>

#include <random>

namespace heft {
namespace {

TEST(Statistics, MedianAndRobustStdIgnoreOutliers) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 2.0, 3.0}), 2.5);
  EXPECT_EQ(median({}), 0.0);
  std::mt19937 random(1);
  std::normal_distribution<double> normal(5.0, 2.0);
  std::vector<double> values(5000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = i % 10 == 0 ? 1e6 : normal(random);
  EXPECT_NEAR(robustStd(values), 2.0, 0.4);
}

Eigen::VectorXd autoregressive(const Eigen::VectorXd& a, double sigma, int n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, sigma);
  Eigen::VectorXd e = Eigen::VectorXd::Zero(n);
  for (int k = 0; k < n; ++k) {
    e(k) = normal(random);
    for (Eigen::Index i = 0; i < a.size() && k - 1 - i >= 0; ++i) e(k) += a(i) * e(k - 1 - i);
  }
  return e;
}

TEST(Statistics, ShareAlongOneDirection) {
  const Eigen::Vector3d a(1.0, 2.0, -2.0), b(2.0, 1.0, 2.0);  // As long, at right angles
  EXPECT_NEAR(shareAlongOneDirection(a * a.transpose()), 1.0, 1e-12);
  EXPECT_NEAR(shareAlongOneDirection(3.0 * a * a.transpose() + b * b.transpose()), 0.75, 1e-12);
  EXPECT_EQ(shareAlongOneDirection(Eigen::Matrix3d::Zero()), 0.0);
}

TEST(Statistics, FindsAutoregressiveNoise) {
  const Eigen::VectorXd truth = Eigen::Vector2d(1.2, -0.5);
  const Eigen::VectorXd e = autoregressive(truth, 0.3, 20000, 2);
  AutoCovariance sums(6);
  sums.add(e.head(8000), Eigen::VectorXd::Ones(8000));
  sums.add(e.tail(12000), Eigen::VectorXd::Ones(12000));
  const ArModel model = sums.fit();
  ASSERT_GE(model.order(), 2);
  EXPECT_NEAR(model.coefficients(0), 1.2, 0.03);
  EXPECT_NEAR(model.coefficients(1), -0.5, 0.03);
  EXPECT_NEAR(model.sigma, 0.3, 0.01);
  EXPECT_NEAR(model.gain(), 1.0 / 0.3, 0.4);
}

TEST(Statistics, WhiteNoiseNeedsNoMemory) {
  const Eigen::VectorXd e = autoregressive({}, 1.0, 3000, 3);
  AutoCovariance sums(6);
  sums.add(e, Eigen::VectorXd::Ones(e.size()));
  EXPECT_EQ(sums.fit().order(), 0);
  // Orders beyond what BIC asks for find hardly anything.
  EXPECT_NEAR(sums.fit(2).gain() * sums.fit(2).sigma, 1.0, 0.1);
}

TEST(Statistics, OneOrderMoreThanBicGivesSlowNoiseItsStrength) {
  // White noise on top of first-order noise, as a sensor has both: BIC settles for one order where 800 samples cannot
  // prove a second one, and then the slow noise comes out too weak.
  double plain = 0.0, beyond = 0.0;
  const int sets = 200;
  const double truth = std::sqrt(0.8 + 1.0 / (0.35 * 0.35));  // of the sum's long-run deviation
  for (int set = 0; set < sets; ++set) {
    const auto seed = static_cast<unsigned>(100 + 2 * set);
    const Eigen::VectorXd e = autoregressive(Eigen::VectorXd::Constant(1, 0.65), 1.0, 800, seed) +
                              autoregressive({}, std::sqrt(0.8), 800, seed + 1);
    AutoCovariance sums(8);
    sums.add(e, Eigen::VectorXd::Ones(e.size()));
    const ArModel one = sums.fit(), more = sums.fit(1);
    EXPECT_EQ(more.order(), one.order() + 1);
    plain += one.gain() * one.sigma / sets;
    beyond += more.gain() * more.sigma / sets;
  }
  EXPECT_LT(plain, beyond);
  EXPECT_LT(std::abs(beyond - truth), std::abs(plain - truth));
}

TEST(Statistics, WeightZeroLeavesSpikesOut) {
  Eigen::VectorXd e = autoregressive({}, 1.0, 3000, 4);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(3000);
  for (int k = 0; k < 3000; k += 100) {
    e(k) = 1000.0;
    weights(k) = 0.0;
  }
  AutoCovariance sums(4);
  sums.add(e, weights);
  EXPECT_NEAR(sums.fit().sigma, 1.0, 0.05);
}

}  // namespace
}  // namespace heft
