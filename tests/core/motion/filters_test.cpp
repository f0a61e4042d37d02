#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/motion/denoiser.h"
#include "core/motion/low_pass.h"
#include "core/motion/resample.h"
#include "core/motion/savitzky_golay.h"

namespace heft {
namespace {

constexpr double kPi = std::numbers::pi;

Channels sine(double hz, double rate, Eigen::Index n) {
  Channels out(n, 1);
  for (Eigen::Index k = 0; k < n; ++k) out(k, 0) = std::sin(2 * kPi * hz * static_cast<double>(k) / rate);
  return out;
}

double middleAmplitude(const Channels& signal) {
  return signal.middleRows(signal.rows() / 4, signal.rows() / 2).cwiseAbs().maxCoeff();
}

TEST(LowPass, PassesSlowStopsFastAndShiftsNothing) {
  const auto sections = butterworthLowPass(6, 20.0, 1000.0);
  for (const auto& [hz, gain] : {std::pair{2.0, 1.0}, std::pair{20.0, 0.5}, std::pair{60.0, 0.0}}) {
    Channels signal = padded(sine(hz, 1000.0, 4000), 200);
    filterForwardBackward(sections, signal);
    EXPECT_NEAR(middleAmplitude(signal), gain, 0.005) << hz << " Hz";
  }
  Channels slow = padded(sine(2.0, 1000.0, 4000), 200);
  filterForwardBackward(sections, slow);
  EXPECT_LT((slow.middleRows(1200, 1600) - sine(2.0, 1000.0, 4000).middleRows(1000, 1600)).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(LowPass, LeavesConstantsAndRampsAloneEvenAtTheEnds) {
  Channels ramp(500, 2);
  for (int k = 0; k < 500; ++k) ramp.row(k) << 7.0, 3.0 + 0.01 * k;
  Channels signal = padded(ramp, 200);
  filterForwardBackward(butterworthLowPass(6, 20.0, 1000.0), signal);
  EXPECT_LT((signal.middleRows(200, 500) - ramp).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(LowPass, RefusesImpossibleCorners) {
  EXPECT_THROW(butterworthLowPass(6, 500.0, 1000.0), std::invalid_argument);
  EXPECT_THROW(butterworthLowPass(5, 20.0, 1000.0), std::invalid_argument);
}

/// A guided motion with a tremor on top keeps both whole; what is noise between them and above goes.
TEST(Denoiser, KeepsWhatStandsOutOfTheNoise) {
  constexpr double kRate = 1000.0, kNoise = 1e-4, kTremor = 4e-4;
  constexpr Eigen::Index kRows = 20000;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Channels truth(kRows, 2), recorded(kRows, 2);
  for (Eigen::Index k = 0; k < kRows; ++k) {
    const double t = static_cast<double>(k) / kRate;
    truth(k, 0) = 0.4 * std::sin(2.1 * t) + 0.1 * std::sin(5.3 * t + 1.0) + kTremor * std::sin(2 * kPi * 10.2 * t);
    truth(k, 1) = 0.3 * std::sin(1.7 * t);
    for (Eigen::Index c = 0; c < 2; ++c) recorded(k, c) = truth(k, c) + kNoise * normal(random);
  }
  const Denoiser denoiser(recorded, kRate);
  EXPECT_NEAR(denoiser.keptHz(), 10.2, 1.6);  // A line is three wide
  Channels kept = padded(recorded, 1000);
  denoiser.apply(kept);
  const MatrixXd off = (kept.middleRows(1000, kRows) - truth).middleRows(1000, kRows - 2000);
  // Some 6 Hz of 500 that noise fills are left to it, and a little of the tremor goes with its neighbours' noise.
  for (Eigen::Index c = 0; c < 2; ++c)
    EXPECT_LT(std::sqrt(off.col(c).squaredNorm() / static_cast<double>(off.rows())), 0.2 * kNoise) << c;
  // Of a motion that is not its own, the same is kept.
  Channels other = padded(sine(10.2, kRate, kRows).replicate(1, 2), 1000);
  denoiser.apply(other);
  EXPECT_GT(middleAmplitude(other.col(0)), 0.9);
  EXPECT_LT(middleAmplitude(other.col(1)), 0.02);
}

TEST(Denoiser, KeepsAllWhereNoiseCannotBeTold) {
  for (const auto& [rate, rows] : {std::pair{100.0, Eigen::Index{3000}}, std::pair{1000.0, Eigen::Index{5000}}}) {
    const Channels signal = sine(20.0, rate, rows);
    const Denoiser denoiser(signal, rate);
    Channels kept = signal;
    denoiser.apply(kept);
    EXPECT_EQ(kept, signal);
    EXPECT_TRUE(std::isinf(denoiser.keptHz()));
  }
}

TEST(CentralDifference, IsExactToATenthOfTheRate) {
  const double rate = 100.0, hz = 10.0;
  const Channels signal = sine(hz, rate, 100);
  const double w = 2 * kPi * hz;
  for (Eigen::Index k = 10; k < 90; ++k) {
    const double t = static_cast<double>(k) / rate;
    EXPECT_NEAR(centralDifferenceKernel(1, rate).dot(signal.col(0).segment(k - 4, 9)), w * std::cos(w * t), 1e-3 * w);
    EXPECT_NEAR(centralDifferenceKernel(2, rate).dot(signal.col(0).segment(k - 4, 9)), -w * w * std::sin(w * t),
                1e-3 * w * w);
  }
}

TEST(CentralDifference, ReachesFurtherForSlowerRates) {
  // A tremor of 10 Hz that was sampled at 30 Hz.
  constexpr int kReach = 16;
  const double rate = 30.0, w = 2 * kPi * 10.0;
  const Channels signal = sine(10.0, rate, 100);
  for (Eigen::Index k = kReach; k < 100 - kReach; ++k) {
    const double t = static_cast<double>(k) / rate;
    const auto about = [&](int reach) { return signal.col(0).segment(k - reach, 2 * reach + 1); };
    EXPECT_NEAR(centralDifferenceKernel(1, rate, kReach).dot(about(kReach)), w * std::cos(w * t), 0.03 * w);
    EXPECT_NEAR(centralDifferenceKernel(2, rate, kReach).dot(about(kReach)), -w * w * std::sin(w * t), 0.03 * w * w);
  }
}

TEST(AveragingKernel, IsCentredAndSumsToOne) {
  for (const int stride : {1, 2, 3, 4, 5, 20}) {
    const VectorXd kernel = averagingKernel(stride);
    EXPECT_EQ(kernel.size() % 2, 1);
    EXPECT_NEAR(kernel.sum(), 1.0, 1e-14);
    EXPECT_TRUE(kernel.isApprox(kernel.reverse()));
  }
}

TEST(SavitzkyGolay, ReproducesPolynomialsAndTheirDerivativesEverywhere) {
  const double rate = 100.0;
  for (const auto& [order, window] : {std::pair{3, 10}, std::pair{2, 5}, std::pair{5, 31}, std::pair{7, 101}}) {
    const SavitzkyGolay filter(order, window);
    Channels value(200, 1), first(200, 1), second(200, 1);
    for (int k = 0; k < 200; ++k) {
      const double t = k / rate - 1.0;
      value(k, 0) = first(k, 0) = second(k, 0) = 0.0;
      for (int p = 0; p <= order; ++p) {
        value(k, 0) += std::pow(t, p);
        if (p >= 1) first(k, 0) += p * std::pow(t, p - 1);
        if (p >= 2) second(k, 0) += p * (p - 1) * std::pow(t, p - 2);
      }
    }
    EXPECT_LT((filter.apply(value, 0, rate) - value).cwiseAbs().maxCoeff(), 1e-9) << order << " " << window;
    EXPECT_LT((filter.apply(value, 1, rate) - first).cwiseAbs().maxCoeff(), 1e-6) << order << " " << window;
    EXPECT_LT((filter.apply(value, 2, rate) - second).cwiseAbs().maxCoeff(), 1e-3) << order << " " << window;
  }
}

TEST(SavitzkyGolay, KnownWeightsOfTheFivePointQuadratic) {
  const VectorXd weights = SavitzkyGolay(2, 5).weights(0);
  EXPECT_TRUE(weights.isApprox((VectorXd(5) << -3, 12, 17, 12, -3).finished() / 35.0, 1e-12));
}

TEST(SavitzkyGolay, ThePapersWindowOfTenBecomesEleven) {
  EXPECT_EQ(SavitzkyGolay(3, 10).window(), 11);
  EXPECT_THROW(SavitzkyGolay(5, 5), std::invalid_argument);
  EXPECT_THROW(SavitzkyGolay(3, 11).apply(Channels::Zero(5, 1), 0, 1.0), std::invalid_argument);
}

TEST(Resample, RoundedTimeStampsAreAGrid) {
  VectorXd time(2001);
  for (int k = 0; k <= 2000; ++k) time(k) = std::round(k / 697.3 * 1e6) / 1e6;
  const UniformGrid grid = gridFor(time);
  EXPECT_TRUE(grid.exact);
  EXPECT_NEAR(grid.rateHz, 697.3, 1e-3);
}

TEST(Resample, JitterIsInterpolatedToThirdOrder) {
  VectorXd time(1000);
  MatrixXd values(1000, 1);
  for (int k = 0; k < 1000; ++k) {
    time(k) = 0.01 * k + (k % 3 == 1 ? 0.003 : 0.0);
    values(k, 0) = std::sin(2 * kPi * 0.7 * time(k));
  }
  const UniformGrid grid = gridFor(time);
  EXPECT_FALSE(grid.exact);
  const Channels out = onGrid(grid, time, values);
  for (Eigen::Index k = 5; k < grid.size - 5; ++k)
    EXPECT_NEAR(out(k, 0), std::sin(2 * kPi * 0.7 * (grid.start + static_cast<double>(k) / grid.rateHz)), 1e-5);
}

/// A fifth of a second without samples is bridged by what lies beside it, a second is not.
TEST(Resample, AGapIsBridged) {
  const auto worst = [](double seconds) {
    std::vector<double> kept;
    for (int k = 0; k < 3000; ++k)
      if (const double t = 0.002 * k; t < 2.0 || t > 2.0 + seconds) kept.push_back(t);
    const VectorXd time = Eigen::Map<const VectorXd>(kept.data(), std::ssize(kept));
    const auto wave = [](double t) { return std::sin(2 * kPi * 0.5 * t); };
    const UniformGrid grid = gridFor(time);
    const Channels out = onGrid(grid, time, time.unaryExpr(wave));
    double error = 0.0;
    for (Eigen::Index k = 0; k < grid.size; ++k)
      error = std::max(error, std::abs(out(k, 0) - wave(grid.start + static_cast<double>(k) / grid.rateHz)));
    return error;
  };
  EXPECT_LT(worst(0.2), 0.005);
  EXPECT_GT(worst(1.0), 0.1) << "a straight line";
}

}  // namespace
}  // namespace heft
