// Delays, filters and averages of signals against what they are defined as.
#include "core/diagnosis/signals/signals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace heft::diagnosis {
namespace {

constexpr double kRate = 200.0;

MatrixXd wave(double frequency, double shift = 0.0) {
  MatrixXd out(2, 800);
  for (Eigen::Index k = 0; k < out.cols(); ++k) {
    const double t = static_cast<double>(k) / kRate - shift;
    out(0, k) = std::sin(2.0 * std::numbers::pi * frequency * t);
    out(1, k) = 1.0 + 0.5 * std::cos(2.0 * std::numbers::pi * frequency * t);
  }
  return out;
}

TEST(Delayed, IsTheSignalReadEarlier) {
  for (const double delay : {0.0, 0.005, 0.0123, -0.0077, 0.08}) {
    const MatrixXd error = delayed(wave(4.0), delay, kRate) - wave(4.0, delay);
    EXPECT_LT(error.middleCols(40, 700).cwiseAbs().maxCoeff(), 2e-5) << delay;
  }
}

TEST(OnePole, HasTheGainAndLagOfTheEquation) {
  for (const double T : {5e-4, 2e-3, 2e-2, 0.2}) {
    const double w = 2.0 * std::numbers::pi * 3.0;
    const MatrixXd out = onePole(wave(3.0), T, kRate);
    const double gain = 1.0 / std::sqrt(1.0 + w * w * T * T), lag = std::atan(w * T) / w;
    // What starts in balance has settled after some time constants.
    const MatrixXd expected = gain * wave(3.0, lag).row(0);
    for (Eigen::Index k = std::min<Eigen::Index>(700, static_cast<Eigen::Index>(12.0 * T * kRate) + 10); k < 790; ++k)
      EXPECT_NEAR(out(0, k), expected(0, k), 2e-4) << T << " at " << k;
  }
}

TEST(MeanSince, HasTheGainAndLagOfAMean) {
  for (const double duration : {1e-4, 7e-3, 0.0333, 0.2}) {
    const double half = std::numbers::pi * 3.0 * duration, gain = std::sin(half) / half;
    const MatrixXd error = meanSince(wave(3.0), duration, kRate).row(0) - gain * wave(3.0, 0.5 * duration).row(0);
    EXPECT_LT(error.middleCols(60, 700).cwiseAbs().maxCoeff(), 2e-5) << duration;
    const MatrixXd ones = MatrixXd::Constant(6, 100, 7.0);
    EXPECT_LT((meanSince(ones, duration, kRate) - ones).cwiseAbs().maxCoeff(), 1e-9) << duration;
  }
}

TEST(ThroughSpring, HasTheResponseOfTheEquation) {
  for (const double rings : {12.0, 35.0, 60.0, 250.0})
    for (const double f : {0.5, 3.0, 8.0}) {
      const double damping = 0.1, omega = 2.0 * std::numbers::pi * rings, w = 2.0 * std::numbers::pi * f;
      MatrixXd u(1, 1200);
      for (Eigen::Index k = 0; k < u.cols(); ++k) u(0, k) = std::sin(w * static_cast<double>(k) / kRate);
      const MatrixXd y = diagnosis::throughSpring(u, rings, damping, kRate);
      const std::complex<double> s(0.0, w),
          gain = (2.0 * damping * omega * s + omega * omega) / (s * s + 2.0 * damping * omega * s + omega * omega);
      for (Eigen::Index k = 1000; k < 1150; ++k)
        EXPECT_NEAR(y(0, k), (gain * std::polar(1.0, w * static_cast<double>(k) / kRate)).imag(),
                    0.03 * std::abs(gain - 1.0) + 1e-5)
            << rings << " Hz, " << f << " Hz";
    }
}

TEST(OnePole, KeepsAConstant) {
  const MatrixXd ones = MatrixXd::Constant(1, 50, 7.0);
  EXPECT_LT((onePole(ones, 0.03, kRate) - ones).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(RateOf, IsTheSlope) {
  const MatrixXd slope = rateOf(wave(1.0), kRate);
  const double w = 2.0 * std::numbers::pi;
  for (Eigen::Index k = 5; k < 790; ++k)
    EXPECT_NEAR(slope(0, k), w * std::cos(w * static_cast<double>(k) / kRate), 2e-3);
}

}  // namespace
}  // namespace heft::diagnosis
