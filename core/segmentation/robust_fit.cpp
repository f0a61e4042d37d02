#include "core/segmentation/robust_fit.h"
#include "core/base/parallel.h"
#include "core/math/linear_algebra.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace heft {

namespace {

constexpr double kWindow = 0.2;     // [s] unit of the robust fit
constexpr double kCap = 4.0;        // root-mean-square misfit of a window, in allowances, beyond which it is not free
constexpr std::size_t kFewest = 5;  // windows that a fit needs

}  // namespace

FitPrior weakPrior() {
  FitPrior prior;
  prior.information << 1e-2, Vector3d::Constant(1.0), Vector6d::Constant(1e2), Vector6d::Constant(1e-6);
  return prior;
}

FitPrior priorFrom(const Payload& payload, const Payload& std) {
  FitPrior prior = weakPrior();
  const Vector10d phi = toParameters(payload);
  prior.mean.head<10>() = phi;
  // An allowance is a few tenths of a newton: information in its units is less than in standard deviations, so that a
  // poor first estimate gives way to the data.
  prior.information(0) += 1.0 / std::pow(std::max(0.03 * payload.mass, std.mass), 2);
  for (int i = 0; i < 3; ++i)
    prior.information(1 + i) += 1.0 / std::pow(std::max(payload.mass * std::max(0.005, std.com(i)), 1e-4), 2);
  return prior;
}

WindowMatrix normalMatrix(const WrenchRows& rows, const Vector6d& scale, Eigen::Index from, Eigen::Index to) {
  constexpr Eigen::Index kBlocks = 40;  // At once: some rows make the product worth its set-up
  const Vector6d inverse = scale.cwiseInverse();
  const Matrix6d biases = inverse.asDiagonal();
  WindowMatrix N = WindowMatrix::Zero();
  Eigen::Matrix<double, 6 * kBlocks, 17> A;
  for (Eigen::Index first = from; first < to; first += kBlocks) {
    const Eigen::Index count = std::min(kBlocks, to - first);
    for (Eigen::Index i = 0; i < count; ++i) {
      A.block<6, 10>(6 * i, 0) = inverse.asDiagonal() * rows.Y[static_cast<std::size_t>(first + i)];
      A.block<6, 6>(6 * i, 10) = biases;
      A.block<6, 1>(6 * i, 16) = inverse.cwiseProduct(rows.wrench.col(first + i));
    }
    N.selfadjointView<Eigen::Lower>().rankUpdate(A.topRows(6 * count).transpose());
  }
  return N.selfadjointView<Eigen::Lower>();
}

FitVector solveNormal(const WindowMatrix& N, const FitPrior& prior) {
  Eigen::Matrix<double, 16, 16> H = N.topLeftCorner<16, 16>();
  H.diagonal() += prior.information;
  return solveSymmetric(H, N.topRightCorner<16, 1>() + prior.information.cwiseProduct(prior.mean));
}

double energyOf(const WindowMatrix& N, const FitVector& x) {
  Eigen::Matrix<double, 17, 1> z;
  z << -x, 1.0;
  return std::max(0.0, z.dot(N.lazyProduct(z)));
}

Eigen::Matrix<double, 6, Eigen::Dynamic> residualOf(const WrenchRows& rows, const FitVector& x) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> residual(6, rows.size());
  for (Eigen::Index k = 0; k < rows.size(); ++k)
    residual.col(k) = rows.wrench.col(k) - rows.Y[static_cast<std::size_t>(k)] * x.head<10>() - x.tail<6>();
  return residual;
}

Vector6d allowancesOf(const WrenchRows& rows) {
  Vector6d scale;
  scale << Vector3d::Constant(0.1), Vector3d::Constant(0.01);
  const auto residual = residualOf(rows, solveNormal(normalMatrix(rows, scale, 0, rows.size()), weakPrior()));
  Vector6d allowed;
  for (int c = 0; c < 6; ++c) {
    std::vector<double> steps;
    for (Eigen::Index k = 1; k < rows.size(); ++k) steps.push_back(std::abs(residual(c, k) - residual(c, k - 1)));
    // A normal distribution has 30 % of its values within 0.385 standard deviations; contact may fill more than half.
    const auto low = steps.begin() + static_cast<std::ptrdiff_t>(0.3 * static_cast<double>(steps.size()));
    if (low == steps.end()) return scale;
    std::nth_element(steps.begin(), low, steps.end());
    const double scatter = *low / 0.385;
    const double range = rows.wrench.row(c).maxCoeff() - rows.wrench.row(c).minCoeff();
    allowed(c) = std::max(3.0 * scatter, std::min(c < 3 ? 0.15 : 0.015, 0.03 * range));
  }
  // A channel that hardly moves is no better than its neighbours.
  const double force = std::max(allowed.head<3>().maxCoeff(), 1e-3),
               torque = std::max(allowed.tail<3>().maxCoeff(), 1e-4);
  for (int c = 0; c < 6; ++c) allowed(c) = std::max(allowed(c), 0.5 * (c < 3 ? force : torque));
  return allowed;
}

FitWindows windowsOf(const WrenchRows& rows, const Vector6d& allowed) {
  FitWindows windows;
  windows.length = std::max<Eigen::Index>(1, std::lround(kWindow * rows.rateHz));
  for (Eigen::Index k = 0; k + windows.length <= rows.size(); k += windows.length)
    windows.matrices.push_back(normalMatrix(rows, allowed, k, k + windows.length));
  windows.cap = kCap * kCap * 6.0 * static_cast<double>(windows.length);
  return windows;
}

CappedFit cappedFit(const FitWindows& windows, std::size_t from, std::size_t to, const std::vector<char>& usable,
                    const FitPrior& prior, int starts) {
  std::vector<std::size_t> members;
  for (std::size_t w = from; w < to; ++w)
    if (usable.empty() || usable[w] != 0) members.push_back(w);
  if (members.size() < kFewest) return {prior.mean, 0.0};
  const auto concentrate = [&](CappedFit fit, int steps) {
    for (int s = 0; s < steps; ++s) {
      WindowMatrix N = WindowMatrix::Zero();
      std::size_t kept = 0;
      for (const std::size_t w : members)
        if (energyOf(windows.matrices[w], fit.x) < windows.cap) {
          N += windows.matrices[w];
          ++kept;
        }
      if (kept < kFewest) break;
      const FitVector next = solveNormal(N, prior);
      if (next == fit.x) break;  // the same windows again
      fit.x = next;
    }
    fit.energy = 0.0;
    for (const std::size_t w : members) fit.energy += std::min(windows.cap, energyOf(windows.matrices[w], fit.x));
    return fit;
  };
  std::mt19937 random(20240229);  // raw engine output only: the same on every platform
  std::vector<WindowMatrix> beginnings(static_cast<std::size_t>(starts) + 1, WindowMatrix::Zero());
  for (const std::size_t w : members) beginnings.front() += windows.matrices[w];
  for (std::size_t start = 1; start < beginnings.size(); ++start)
    for (int i = 0; i < 8; ++i) beginnings[start] += windows.matrices[members[random() % members.size()]];
  std::vector<CappedFit> best(beginnings.size());
  parallelFor(best.size(), [&](std::size_t i) { best[i] = concentrate({solveNormal(beginnings[i], prior), 0.0}, 2); });
  const auto byEnergy = [](const CappedFit& a, const CappedFit& b) { return a.energy < b.energy; };
  std::sort(best.begin(), best.end(), byEnergy);
  best.resize(std::min<std::size_t>(best.size(), 5));
  parallelFor(best.size(), [&](std::size_t i) { best[i] = concentrate(best[i], 15); });
  return *std::min_element(best.begin(), best.end(), byEnergy);
}

}  // namespace heft
