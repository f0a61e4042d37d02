#include "core/motion/denoiser.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "core/base/stop.h"
#include "core/math/periodogram.h"
#include "core/math/statistics.h"

namespace heft {

namespace {

constexpr double kWindow = 1.0;  ///< [s] T: a line each hertz; finer ones remember the ends of a recording for longer
constexpr Eigen::Index kLines = 45;      ///< Up to 45 Hz
constexpr Eigen::Index kNoiseFrom = 30;  ///< Line from which on there is noise only: no arm moves a tool at 30 Hz
constexpr Eigen::Index kGuided = 2;      ///< Up to this line everything is motion
constexpr double kShortest = 8.0;        ///< [s]
constexpr double kSlowest = 120.0;       ///< [Hz]
constexpr int kDifferences = 3;          ///< Slow motion must not leak into lines where it is noise's turn
/// Spectrum over noise from which on it is motion: the mean of some forty windows strays by a fifth.
constexpr double kStandsOut = 2.5;
constexpr double kWhole = 0.9;  ///< Gain

Channels differences(Channels x) {
  for (int i = 0; i < kDifferences; ++i) x = Channels(x.bottomRows(x.rows() - 1) - x.topRows(x.rows() - 1));
  return x;
}

}  // namespace

Denoiser::Denoiser(const Channels& signal, double rateHz) : rateHz_(rateHz) {
  if (rateHz < kSlowest || static_cast<double>(signal.rows()) < kShortest * rateHz) return;
  const MatrixXd x = differences(signal).transpose();
  const auto length = static_cast<Eigen::Index>(kWindow * rateHz);
  // What differences do to white noise
  VectorXd white(kLines);
  for (Eigen::Index k = 0; k < kLines; ++k)
    white(k) = std::pow(2.0 * std::sin(std::numbers::pi * static_cast<double>(k + 1) / static_cast<double>(length)),
                        2 * kDifferences);
  MatrixXd mean = MatrixXd::Zero(x.rows(), kLines);
  double windows = 0.0;
  std::vector<std::vector<double>> high(static_cast<std::size_t>(x.rows()));
  for (Eigen::Index from = 0; from + length <= x.cols(); from += length / 2) {
    stopPoint();
    const MatrixXd power = taperedPower(x.middleCols(from, length), kLines) * white.cwiseInverse().asDiagonal();
    mean += power;
    windows += 1.0;
    for (Eigen::Index c = 0; c < x.rows(); ++c)
      for (Eigen::Index k = kNoiseFrom; k < kLines; ++k) high[static_cast<std::size_t>(c)].push_back(power(c, k));
  }
  mean /= windows;
  gains_ = MatrixXd::Ones(x.rows(), kLines + 1);
  for (Eigen::Index c = 0; c < x.rows(); ++c) {
    // Half of what is spread as a square of two normal numbers is below ln 2 of its mean; knocks do not count.
    const double noise = median(std::move(high[static_cast<std::size_t>(c)])) / std::numbers::ln2;
    for (Eigen::Index k = kGuided; k < kLines; ++k) {
      const double stands = mean(c, k) / std::max(noise, 1e-300);
      gains_(c, k + 1) = stands > kStandsOut ? 1.0 - 1.0 / stands : 0.0;
    }
  }
}

void Denoiser::apply(Channels& signal) const {
  if (gains_.size() == 0) return;
  const Eigen::Index n = signal.rows();
  Eigen::Index size = 1;
  while (size < n) size *= 2;
  Eigen::FFT<double> transform;
  std::vector<double> samples(static_cast<std::size_t>(size));
  std::vector<std::complex<double>> spectrum;
  for (Eigen::Index c = 0; c < signal.cols(); ++c) {
    // A ring without a jump: the line from end to end is taken off, and kept whole.
    const double first = signal(0, c), slope = (signal(n - 1, c) - first) / static_cast<double>(n - 1);
    const auto line = [&](Eigen::Index i) { return first + slope * static_cast<double>(i); };
    for (Eigen::Index i = 0; i < size; ++i) samples[static_cast<std::size_t>(i)] = i < n ? signal(i, c) - line(i) : 0.0;
    stopPoint();
    transform.fwd(spectrum, samples);
    for (Eigen::Index i = 0; i < size; ++i) {
      const double at = kWindow * rateHz_ * static_cast<double>(std::min(i, size - i)) / static_cast<double>(size);
      const auto below = static_cast<Eigen::Index>(at);
      double gain = 0.0;
      if (below < kLines) gain = std::lerp(gains_(c, below), gains_(c, below + 1), at - static_cast<double>(below));
      spectrum[static_cast<std::size_t>(i)] *= gain;
    }
    transform.inv(samples, spectrum);
    for (Eigen::Index i = 0; i < n; ++i) signal(i, c) = samples[static_cast<std::size_t>(i)] + line(i);
  }
}

double Denoiser::keptHz() const {
  if (gains_.size() == 0) return std::numeric_limits<double>::infinity();
  Eigen::Index last = kGuided;
  for (Eigen::Index k = kGuided; k < gains_.cols(); ++k)
    if (gains_.col(k).maxCoeff() > kWhole) last = k;
  return static_cast<double>(last) / kWindow;
}

}  // namespace heft
