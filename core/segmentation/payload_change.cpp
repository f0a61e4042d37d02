#include "core/segmentation/payload_change.h"
#include "core/math/linear_algebra.h"

#include <algorithm>
#include <cmath>

namespace heft {

namespace {

constexpr std::size_t kShortestPart = 10;  // windows, 2 s
constexpr std::size_t kFewestFree = 8;     // windows on each side that a fit explains
constexpr int kStarts = 6;
constexpr int kMostDepth = 3;
constexpr std::size_t kSplits = 40;  // tried at the first look

/// The unknowns [x, extra], where the columns of `extra` are those of unknowns first, first + 1, ... times `share`.
class ExtendedFit {
 public:
  ExtendedFit(int first, int count) : first_(first), count_(count), M_(MatrixXd::Zero(17 + count, 17 + count)) {}

  void add(const WindowMatrix& window, double share) {
    MatrixXd T = MatrixXd::Zero(17, 17 + count_);
    T.topLeftCorner<16, 16>().setIdentity();
    T.block(first_, 16, count_, count_) = share * MatrixXd::Identity(count_, count_);
    T(16, 16 + count_) = 1.0;
    M_ += congruence(T.transpose(), window);
  }
  /// Solves; the energy that is left.
  double solve(const FitPrior& prior) {
    const Eigen::Index n = 16 + count_;
    MatrixXd H = M_.topLeftCorner(n, n);
    VectorXd g = M_.topRightCorner(n, 1);
    H.diagonal().head<16>() += prior.information;
    H.diagonal().tail(count_) += prior.information.segment(first_, count_).cwiseMin(1.0);
    g.head<16>() += prior.information.cwiseProduct(prior.mean);
    VectorXd z(n + 1);
    z << -solveSymmetric(H, g), 1.0;
    extra_ = -z.segment(16, count_);
    return std::max(0.0, z.dot(M_ * z));
  }
  const VectorXd& extra() const { return extra_; }

 private:
  int first_, count_;
  MatrixXd M_;
  VectorXd extra_;
};

constexpr int kMassAndMoments = 4;
constexpr int kBiasFirst = 10, kBiases = 6;

WindowMatrix sumOf(const FitWindows& windows, const std::vector<std::size_t>& members) {
  WindowMatrix sum = WindowMatrix::Zero();
  for (const std::size_t w : members) sum += windows.matrices[w];
  return sum;
}

double cappedEnergy(const FitWindows& windows, const std::vector<char>& usable, std::size_t w, const FitVector& x) {
  return usable.empty() || usable[w] != 0 ? std::min(windows.cap, energyOf(windows.matrices[w], x)) : 0.0;
}

/// A quick look at recordings that one payload explains nearly everywhere: no place where a step of the payload would
/// help much.
bool noStepSeen(const FitWindows& windows, const PayloadPart& whole, std::size_t stride, const FitPrior& prior) {
  if (10 * whole.free.size() < 9 * (whole.to - whole.from)) return false;
  const WindowMatrix all = sumOf(windows, whole.free);
  const double single = energyOf(all, solveNormal(all, prior));
  WindowMatrix before = WindowMatrix::Zero();
  for (std::size_t i = 0; i < whole.free.size(); ++i) {
    before += windows.matrices[whole.free[i]];
    if (i % stride != 0) continue;
    ExtendedFit step(0, kMassAndMoments);
    step.add(before, 0.0);
    step.add(all - before, 1.0);
    if (step.solve(prior) < 0.6 * single) return false;
  }
  return true;
}

/// The best place to cut [from, to), or `to` if none is clear.
std::size_t bestCut(const FitWindows& windows, const std::vector<char>& usable, const FitPrior& prior, std::size_t from,
                    std::size_t to) {
  if (to - from < 2 * kShortestPart) return to;
  const std::size_t stride = std::max<std::size_t>(1, (to - from) / kSplits);
  if (noStepSeen(windows, partOf(windows, usable, prior, from, to, kStarts), stride, prior)) return to;
  std::size_t best = to;
  double least = 0.0;
  CappedFit left, right;
  for (std::size_t cut = from + kShortestPart; cut + kShortestPart <= to; cut += stride) {
    const CappedFit a = cappedFit(windows, from, cut, usable, prior, kStarts);
    const CappedFit b = cappedFit(windows, cut, to, usable, prior, kStarts);
    if (best != to && a.energy + b.energy >= least) continue;
    best = cut;
    least = a.energy + b.energy;
    left = a;
    right = b;
  }
  // The fits hold for the places in between.
  double running = 0.0, lowest = 0.0;
  std::size_t refined = best;
  for (std::size_t w = best - std::min(stride, best - from); w < std::min(best + stride, to); ++w) {
    running += cappedEnergy(windows, usable, w, left.x) - cappedEnergy(windows, usable, w, right.x);
    if (running < lowest) {
      lowest = running;
      refined = w + 1;
    }
  }
  return std::clamp(refined, from + kShortestPart, to - kShortestPart);
}

void split(const FitWindows& windows, const std::vector<char>& usable, const FitPrior& prior, std::size_t from,
           std::size_t to, int depth, std::vector<PayloadPart>& parts) {
  if (depth < kMostDepth) {
    const std::size_t cut = bestCut(windows, usable, prior, from, to);
    if (cut != to) {
      const PayloadPart a = partOf(windows, usable, prior, from, cut, kStarts);
      const PayloadPart b = partOf(windows, usable, prior, cut, to, kStarts);
      if (!compareParts(windows, a, b, prior).same) {
        split(windows, usable, prior, from, cut, depth + 1, parts);
        split(windows, usable, prior, cut, to, depth + 1, parts);
        return;
      }
    }
  }
  parts.push_back(partOf(windows, usable, prior, from, to, 60));
}

}  // namespace

PayloadPart partOf(const FitWindows& windows, const std::vector<char>& usable, const FitPrior& prior, std::size_t from,
                   std::size_t to, int starts) {
  PayloadPart part{from, to, cappedFit(windows, from, to, usable, prior, starts).x, {}};
  for (std::size_t w = from; w < to; ++w) {
    if (!usable.empty() && usable[w] == 0) continue;
    if (energyOf(windows.matrices[w], part.x) < windows.cap) part.free.push_back(w);
  }
  return part;
}

PayloadStep compareParts(const FitWindows& windows, const PayloadPart& a, const PayloadPart& b, const FitPrior& prior) {
  if (a.free.size() < kFewestFree || b.free.size() < kFewestFree) return {};
  const WindowMatrix before = sumOf(windows, a.free), after = sumOf(windows, b.free);
  const WindowMatrix both = before + after;
  const FitVector x = solveNormal(both, prior);
  const double single = energyOf(both, x);
  ExtendedFit payloadStep(0, kMassAndMoments), biasStep(kBiasFirst, kBiases), drift(kBiasFirst, kBiases);
  for (auto* step : {&payloadStep, &biasStep}) {
    step->add(before, 0.0);
    step->add(after, 1.0);
  }
  for (const auto* part : {&a, &b})
    for (const std::size_t w : part->free)
      drift.add(windows.matrices[w], static_cast<double>(w) / static_cast<double>(windows.size()));
  const double byPayload = payloadStep.solve(prior), byBias = biasStep.solve(prior), byDrift = drift.solve(prior);
  const double massStep = payloadStep.extra()(0);
  // A moved bias that explains it far better is none of this: a constant push, or the sensor's own doing.
  const bool clear = byPayload < 0.4 * single && byPayload < 0.5 * byDrift && byPayload < 2.0 * byBias;
  const bool large = std::abs(massStep) > std::max(0.02 * std::abs(x(0)), 0.008);
  return {!(clear && large), byPayload < 0.5 * byBias, massStep};
}

std::vector<PayloadPart> payloadParts(const FitWindows& windows, const std::vector<char>& usable,
                                      const FitPrior& prior) {
  std::vector<PayloadPart> parts;
  split(windows, usable, prior, 0, windows.size(), 0, parts);
  return parts;
}

}  // namespace heft
