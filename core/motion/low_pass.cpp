#include "core/motion/low_pass.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace heft {

std::vector<Biquad> butterworthLowPass(int order, double cutoffHz, double rateHz) {
  if (order < 2 || order % 2 != 0) throw std::invalid_argument("butterworthLowPass: order must be even and at least 2");
  if (!(cutoffHz > 0.0 && cutoffHz < 0.5 * rateHz))
    throw std::invalid_argument("butterworthLowPass: the cutoff must lie between 0 and half the sampling rate");
  const double k = std::tan(std::numbers::pi * cutoffHz / rateHz);
  std::vector<Biquad> sections;
  for (int i = 0; i < order / 2; ++i) {
    const double damping = 2.0 * std::sin(std::numbers::pi * (2 * i + 1) / (2.0 * order));
    const double norm = 1.0 / (1.0 + damping * k + k * k);
    const double b = k * k * norm;
    sections.push_back({b, 2.0 * b, b, 2.0 * (k * k - 1.0) * norm, (1.0 - damping * k + k * k) * norm});
  }
  return sections;
}

Channels padded(const Channels& signal, Eigen::Index pad) {
  const Eigen::Index n = signal.rows();
  if (n < 2) throw std::invalid_argument("padded: at least two rows are needed");
  Channels out(n + 2 * pad, signal.cols());
  out.middleRows(pad, n) = signal;
  // Where the padding is longer than the signal, the last reflected value is repeated.
  for (Eigen::Index i = 1; i <= pad; ++i) {
    const Eigen::Index j = std::min(i, n - 1);
    out.row(pad - i) = 2.0 * signal.row(0) - signal.row(j);
    out.row(pad + n - 1 + i) = 2.0 * signal.row(n - 1) - signal.row(n - 1 - j);
  }
  return out;
}

void filterForwardBackward(const std::vector<Biquad>& sections, Channels& signal) {
  const Eigen::Index n = signal.rows();
  Eigen::RowVectorXd z1, z2, x;
  const auto pass = [&](const Biquad& s, bool backward) {
    const Eigen::Index first = backward ? n - 1 : 0;
    // Steady state for a constant input equal to the first sample: no start-up transient. Each section has gain 1.
    x = signal.row(first);
    z1 = x * (1.0 - s.b0);
    z2 = x * (s.b2 - s.a2);
    for (Eigen::Index i = 0; i < n; ++i) {
      auto row = signal.row(backward ? n - 1 - i : i);
      x = row;
      row = s.b0 * x + z1;
      z1 = s.b1 * x - s.a1 * row + z2;
      z2 = s.b2 * x - s.a2 * row;
    }
  };
  for (const auto& section : sections) pass(section, false);
  for (const auto& section : sections) pass(section, true);
}

Eigen::RowVectorXd centralDifference(const Channels& signal, Eigen::Index k, int derivative, double rateHz) {
  static constexpr double kFirst[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  static constexpr double kSecond[] = {8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0};
  Eigen::RowVectorXd out;
  if (derivative == 1) {
    out = kFirst[0] * (signal.row(k + 1) - signal.row(k - 1));
    for (int i = 2; i <= 4; ++i) out += kFirst[i - 1] * (signal.row(k + i) - signal.row(k - i));
    return out * rateHz;
  }
  out = -205.0 / 72.0 * signal.row(k);
  for (int i = 1; i <= 4; ++i) out += kSecond[i - 1] * (signal.row(k + i) + signal.row(k - i));
  return out * (rateHz * rateHz);
}

VectorXd averagingKernel(int stride) {
  if (stride % 2 == 1) return VectorXd::Constant(stride, 1.0 / stride);
  VectorXd kernel = VectorXd::Constant(stride + 1, 1.0 / stride);
  kernel(0) = kernel(stride) = 0.5 / stride;
  return kernel;
}

}  // namespace heft
