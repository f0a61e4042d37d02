#include "core/diagnosis/artefacts/sharp_motion.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/diagnosis/calibration.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

/// Means over `reach` columns to either side.
Wrenches blurred(const Wrenches& of, Eigen::Index reach) {
  Wrenches out(6, of.cols());
  for (Eigen::Index n = 0; n < of.cols(); ++n) {
    const Eigen::Index from = std::max<Eigen::Index>(0, n - reach), to = std::min(of.cols(), n + reach + 1);
    out.col(n) = of.middleCols(from, to - from).rowwise().mean();
  }
  return out;
}

/// Whether it has another payload, so that the fit hung on a noise with a long memory: half of the weight is then told
/// to be noise, and sharp motion to hardly matter.
bool isAnother(const Fit& rested, const Fit& fit) {
  return std::abs(rested.model.x(6) - fit.model.x(6)) > kMinorShare * std::abs(rested.model.x(6));
}

/// Without the noise: zero but for where any channel stands out, and around it.
Wrenches standingOut(const Wrenches& of) {
  constexpr Eigen::Index kAround = 3;  // Blocks
  Vector6d usual;
  for (Eigen::Index c = 0; c < 6; ++c) {
    const VectorXd channel = of.row(c).transpose();
    usual(c) = std::max(1e-12, robustStd({channel.begin(), channel.end()}));
  }
  Wrenches out = Wrenches::Zero(6, of.cols());
  for (Eigen::Index n = 0; n < of.cols(); ++n) {
    if (of.col(n).cwiseAbs().cwiseQuotient(usual).maxCoeff() < kStandsOut) continue;
    const Eigen::Index from = std::max<Eigen::Index>(0, n - kAround), to = std::min(of.cols(), n + kAround + 1);
    out.middleCols(from, to - from) = of.middleCols(from, to - from);
  }
  return out;
}

}  // namespace

void weighSharpMotion(std::vector<SmoothingCandidate>& candidates, const SmoothingCandidate& sharper, bool held) {
  constexpr Eigen::Index kReach = 2;  // Blocks: a filter rings
  const Signals& least = candidates[kUsualSmoothing].signals;
  const auto stretches = untouched(least, candidates[kUsualSmoothing]);
  if (stretches.empty()) return;
  Fit fit = fitModel(least, stretches, Model{});
  if (!held) {
    Fit rested = settled(least, stretches, fit);
    if (isAnother(rested, fit)) fit = std::move(rested);
  }
  const Vector10d payload = fit.model.x.tail<10>();
  Vector6d noise;
  for (Eigen::Index c = 0; c < 6; ++c) noise(c) = fit.noise.channels[static_cast<std::size_t>(c)].sigma;
  const auto madeOf = [&](const SmoothingCandidate& candidate) {
    const Signals& signals = candidate.signals;
    return averaged(signals, payloadWrench(signals.kinematics, payload));
  };
  const Wrenches sharpest = madeOf(sharper);
  std::vector<Wrenches> made;
  for (const SmoothingCandidate& candidate : candidates) {
    made.push_back(madeOf(candidate));
    if (made.back().cols() != sharpest.cols()) return;
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    std::vector<Wrenches> lost, lostFast{sharpest - made[i]};
    for (std::size_t less = 0; less < i; ++less)
      (less < kUsualSmoothing ? lostFast : lost).emplace_back(made[less] - made[i]);
    candidates[i].signals.lost = std::make_shared<const std::vector<Wrenches>>(std::move(lost));
    candidates[i].signals.lostFast = std::make_shared<const std::vector<Wrenches>>(std::move(lostFast));
    // What was denoised may be smoother at a stop than one with a low corner.
    std::size_t next = i + 1;
    while (next < candidates.size() && candidates[next].signals.denoised) ++next;
    if (next >= candidates.size()) continue;
    Wrenches noiseScale = blurred((noise.cwiseInverse().asDiagonal() * (made[i] - made[next])).cwiseAbs2(), kReach);
    // A motion that reaches one deviation of the noise nowhere is smooth enough.
    if (noiseScale.maxCoeff() > 1.0)
      candidates[i].signals.noiseScale = std::make_shared<const NoiseScale>(std::move(noiseScale));
  }
}

double gainOfSharpMotion(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  if (signals.lostFast == nullptr) return 0.0;
  const double cost = whitened(flat(fit.residual), fit.noise, stretches).squaredNorm();
  double out = 0.0;
  for (const Wrenches& lost : *signals.lostFast) {
    const Wrenches left = fit.residual - standingOut(lost);
    out = std::max(out, cost - whitened(flat(left), fit.noise, stretches).squaredNorm());
  }
  return out;
}

}  // namespace heft::diagnosis
