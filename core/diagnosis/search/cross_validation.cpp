#include "core/diagnosis/search/cross_validation.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/model/linearisation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"

namespace heft::diagnosis {

namespace {

constexpr int kParts = 10;

/// The usable blocks cut into kParts of equal size, each as stretches.
std::vector<std::vector<Stretch>> parts(const std::vector<Stretch>& stretches) {
  Eigen::Index total = 0;
  for (const auto& s : stretches) total += s.to - s.from;
  std::vector<std::vector<Stretch>> out(kParts);
  Eigen::Index before = 0;
  for (const auto& s : stretches)
    for (Eigen::Index at = s.from; at < s.to;) {
      const Eigen::Index part = std::min<Eigen::Index>(kParts - 1, before * kParts / std::max<Eigen::Index>(1, total));
      const Eigen::Index end = part == kParts - 1 ? total : (part + 1) * total / kParts;
      const Eigen::Index count = std::max<Eigen::Index>(1, std::min(s.to - at, end - before));
      out[static_cast<std::size_t>(part)].push_back({at, at + count});
      at += count;
      before += count;
    }
  return out;
}

std::vector<Stretch> outside(const std::vector<Stretch>& stretches, const std::vector<Stretch>& part,
                             Eigen::Index gap) {
  std::vector<Stretch> out;
  for (auto s : stretches) {
    std::vector<Stretch> left{s};
    for (const auto& hole : part) {
      std::vector<Stretch> next;
      for (const auto& piece : left) {
        if (hole.from - gap > piece.from) next.push_back({piece.from, std::min(piece.to, hole.from - gap)});
        if (hole.to + gap < piece.to) next.push_back({std::max(piece.from, hole.to + gap), piece.to});
      }
      left = std::move(next);
    }
    for (const auto& piece : left)
      if (piece.to - piece.from >= 12) out.push_back(piece);
  }
  return out;
}

}  // namespace

Wrenches heldOutResidual(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  Wrenches out = fit.residual;
  const CachedJacobian columns(signals, fit.model);
  const auto all = parts(stretches);
  parallelFor(all.size(), [&](std::size_t i) {
    const auto training = outside(stretches, all[i], kMomentBlocks);
    if (training.empty()) return;
    const Model model = refitted(signals, training, fit, columns);
    const Wrenches residual = signals.measured - valueOf(signals, model);
    for (const auto& s : all[i]) out.middleCols(s.from, s.to - s.from) = residual.middleCols(s.from, s.to - s.from);
  });
  return out;
}

Eigen::Matrix<double, 10, Eigen::Dynamic> payloadsWithoutParts(const Signals& signals,
                                                               const std::vector<Stretch>& stretches, const Fit& fit) {
  const CachedJacobian columns(signals, fit.model);
  const auto all = parts(stretches);
  Eigen::Matrix<double, 10, Eigen::Dynamic> out(10, std::ssize(all));
  parallelFor(all.size(), [&](std::size_t i) {
    const auto training = outside(stretches, all[i], 0);
    out.col(static_cast<Eigen::Index>(i)) =
        (training.empty() ? fit.model : refitted(signals, training, fit, columns)).x.tail<10>();
  });
  return out;
}

Gain gainOf(const std::vector<Stretch>& stretches, const Noise& noise, const Wrenches& before, const Wrenches& after) {
  Gain out;
  const auto all = parts(stretches);
  std::array<double, 4> sums{};
  double count = 0.0, total = 0.0, gained = 0.0;
  std::vector<double> differences;
  Vector6d scale;
  for (int c = 0; c < 6; ++c) {
    const ArModel& model = noise.channels[static_cast<std::size_t>(c)];
    scale(c) = 1.0 / (model.sigma * std::clamp(std::abs(model.gain()), 1.0, 10.0));
  }
  for (const auto& part : all) {
    double was = 0.0, is = 0.0;
    for (const auto& s : part)
      for (Eigen::Index n = s.from; n < s.to; ++n) {
        sums[0] += before.col(n).head<3>().squaredNorm();
        sums[1] += after.col(n).head<3>().squaredNorm();
        sums[2] += before.col(n).tail<3>().squaredNorm();
        sums[3] += after.col(n).tail<3>().squaredNorm();
        was += scale.cwiseProduct(before.col(n)).squaredNorm();
        is += scale.cwiseProduct(after.col(n)).squaredNorm();
        count += 3.0;
      }
    if (part.empty()) continue;
    ++out.blocks;
    if (is < was) ++out.blocksBetter;
    total += was;
    gained += was - is;
    differences.push_back(was - is);
  }
  if (count <= 0.0 || total <= 0.0) return out;
  out.forceBefore = std::sqrt(sums[0] / count);
  out.forceAfter = std::sqrt(sums[1] / count);
  out.torqueBefore = std::sqrt(sums[2] / count);
  out.torqueAfter = std::sqrt(sums[3] / count);
  out.explainedFraction = gained / total;
  const double mean = gained / static_cast<double>(differences.size());
  double variance = 0.0;
  for (const double d : differences) variance += (d - mean) * (d - mean);
  const double n = static_cast<double>(differences.size());
  const double error = n > 1.0 ? 2.26 * std::sqrt(variance / (n - 1.0) / n) * n / total : 1.0;
  out.lower = out.explainedFraction - error;
  out.upper = out.explainedFraction + error;
  return out;
}

}  // namespace heft::diagnosis
