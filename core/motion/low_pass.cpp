#include "core/motion/low_pass.h"

#include <algorithm>
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

Channels padded(const Channels& signal, Eigen::Index before, Eigen::Index after) {
  const Eigen::Index n = signal.rows();
  if (n < 2) throw std::invalid_argument("padded: at least two rows are needed");
  Channels out(before + n + after, signal.cols());
  out.middleRows(before, n) = signal;
  // Where the padding is longer than the signal, the last reflected value is repeated.
  for (Eigen::Index i = 1; i <= before; ++i) out.row(before - i) = 2.0 * signal.row(0) - signal.row(std::min(i, n - 1));
  for (Eigen::Index i = 1; i <= after; ++i)
    out.row(before + n - 1 + i) = 2.0 * signal.row(n - 1) - signal.row(n - 1 - std::min(i, n - 1));
  return out;
}

namespace {

/// Channels that are filtered side by side.
using Lanes = Eigen::Array<double, 8, 1>;

/// All sections in one sweep over the rows of `count` channels from `first` on. The count is known to the compiler, so
/// that a row goes straight from memory into registers and back.
template <int count>
void sweep(const std::vector<Biquad>& sections, Channels& signal, Eigen::Index first, bool backward) {
  const Eigen::Index n = signal.rows();
  std::vector<Lanes> z1(sections.size()), z2(sections.size());
  Lanes x = Lanes::Zero();
  for (Eigen::Index i = 0; i < n; ++i) {
    double* row = &signal(backward ? n - 1 - i : i, first);
    std::copy_n(row, count, x.data());
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const Biquad& s = sections[k];
      if (i == 0) {
        // Steady state for a constant input equal to the first sample: no start-up transient. Each section has
        // gain 1.
        z1[k] = x * (1.0 - s.b0);
        z2[k] = x * (s.b2 - s.a2);
      }
      const Lanes y = s.b0 * x + z1[k];
      z1[k] = s.b1 * x - s.a1 * y + z2[k];
      z2[k] = s.b2 * x - s.a2 * y;
      x = y;
    }
    std::copy_n(x.data(), count, row);
  }
}

}  // namespace

void filterForwardBackward(const std::vector<Biquad>& sections, Channels& signal) {
  using Sweep = void (*)(const std::vector<Biquad>&, Channels&, Eigen::Index, bool);
  constexpr Sweep kSweeps[] = {sweep<1>, sweep<2>, sweep<3>, sweep<4>, sweep<5>, sweep<6>, sweep<7>, sweep<8>};
  for (Eigen::Index first = 0; first < signal.cols(); first += Lanes::SizeAtCompileTime) {
    const Eigen::Index lanes = std::min<Eigen::Index>(Lanes::SizeAtCompileTime, signal.cols() - first);
    for (const bool backward : {false, true}) kSweeps[lanes - 1](sections, signal, first, backward);
  }
}

VectorXd centralDifferenceKernel(int derivative, double rateHz, int reach) {
  VectorXd kernel = VectorXd::Zero(2 * reach + 1);
  double share = 1.0;  // reach!^2 / ((reach - k)! (reach + k)!), with the sign of k
  for (int k = 1; k <= reach; ++k) {
    share *= (k == 1 ? 1.0 : -1.0) * static_cast<double>(reach - k + 1) / static_cast<double>(reach + k);
    const double weight = derivative == 1 ? share / k * rateHz : 2.0 * share / (k * k) * rateHz * rateHz;
    kernel(reach + k) = weight;
    kernel(reach - k) = derivative == 1 ? -weight : weight;
  }
  if (derivative == 2) kernel(reach) = -kernel.sum();
  return kernel;
}

VectorXd convolved(const VectorXd& a, const VectorXd& b) {
  VectorXd out = VectorXd::Zero(a.size() + b.size() - 1);
  for (Eigen::Index i = 0; i < a.size(); ++i) out.segment(i, b.size()) += a(i) * b;
  return out;
}

VectorXd averagingKernel(int stride) {
  if (stride % 2 == 1) return VectorXd::Constant(stride, 1.0 / stride);
  VectorXd kernel = VectorXd::Constant(stride + 1, 1.0 / stride);
  kernel(0) = kernel(stride) = 0.5 / stride;
  return kernel;
}

}  // namespace heft
