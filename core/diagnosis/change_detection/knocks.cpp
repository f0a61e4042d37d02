#include "core/diagnosis/change_detection/knocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/diagnosis/calibration.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

/// Of each row of `values` (6 x N), over the blocks of `stretches`.
Vector6d mediansIn(const Wrenches& values, const std::vector<Stretch>& stretches) {
  Vector6d out;
  for (Eigen::Index c = 0; c < 6; ++c) {
    std::vector<double> all;
    for (const auto& s : stretches)
      for (Eigen::Index n = s.from; n < s.to; ++n) all.push_back(values(c, n));
    out(c) = median(std::move(all));
  }
  return out;
}

/// The usual power as far as it is known to be more in block `n`: where the motion turns sharply, it makes knocks of
/// its own.
Vector6d knownAt(const Signals& signals, Vector6d usual, Eigen::Index n) {
  if (signals.noiseScale) usual.array() *= 1.0 + signals.noiseScale->times().col(n).array();
  return usual;
}

/// Parts of a third of a second, and the power of what is left in each of them, in units of the noise.
struct Parts {
  Eigen::Index length = 0;         ///< [blocks]
  std::vector<Eigen::Index> from;  ///< First blocks
  std::array<std::vector<double>, 6> power;
};

Parts partsOf(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  Parts out;
  out.length = static_cast<Eigen::Index>(std::max(3.0, std::round(0.3 * signals.blockRate())));
  const VectorXd innovations = whitened(flat(fit.residual), fit.noise, stretches);
  const Eigen::Map<const Wrenches> e(innovations.data(), 6, fit.residual.cols());
  for (const auto& s : stretches)
    for (Eigen::Index n = s.from; n + out.length <= s.to; n += out.length) {
      out.from.push_back(n);
      for (Eigen::Index c = 0; c < 6; ++c)
        out.power[static_cast<std::size_t>(c)].push_back(e.row(c).segment(n, out.length).squaredNorm());
    }
  return out;
}

}  // namespace

std::vector<double> knocksIn(const Signals& signals, const std::vector<Stretch>& stretches, const Model& model) {
  // Power is that beside a straight line through each block. Of 260 recordings 255 have none at 15 times the usual, the
  // others some, such as where friction turns round; three and more at 60 had only a part that rattled.
  const Wrenches left = signals.readings - predicted(signals, model);
  const Eigen::Index m = signals.samplesPerBlock;
  if (m < 4) return {};
  const Eigen::RowVectorXd course = Eigen::RowVectorXd::LinSpaced(m, -1.0, 1.0).normalized();
  Wrenches power = Wrenches::Zero(6, signals.blocks());
  for (Eigen::Index n = 0; n < signals.blocks(); ++n) {
    const Wrenches block = left.middleCols(n * m, m);
    power.col(n) = block.cwiseAbs2().rowwise().sum() -
                   static_cast<double>(m) * Vector6d(block.rowwise().mean()).cwiseAbs2() -
                   Vector6d(block * course.transpose()).cwiseAbs2();
  }
  const Vector6d usual = mediansIn(power, stretches).cwiseMax(1e-12);
  std::vector<double> out;
  for (const auto& s : stretches)
    for (Eigen::Index n = s.from; n < s.to; ++n) {
      const double loud = power.col(n).cwiseQuotient(knownAt(signals, usual, n)).mean(), t = signals.blockTime(n);
      if (loud > kFarOut && (out.empty() || t > out.back() + kEvent)) out.push_back(t);
    }
  return out;
}

std::vector<double> burstsIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  // Of 1,440 recordings, the third loudest part of those with nothing of the kind had 6.2 times the usual power at
  // most; where something rang again and again, 25 (our own test: 7 to 9).
  const Parts parts = partsOf(signals, stretches, fit);
  std::vector<double> out;
  if (parts.from.empty()) return out;
  std::array<double, 6> usual;
  for (std::size_t c = 0; c < 6; ++c) usual[c] = std::max(1e-12, median(parts.power[c]));
  for (std::size_t i = 0; i < parts.from.size(); ++i) {
    double loudest = 0.0;
    for (std::size_t c = 0; c < 6; ++c) {
      const auto row = static_cast<Eigen::Index>(c);
      const double known =
          signals.noiseScale
              ? 1.0 + signals.noiseScale->times().row(row).segment(parts.from[i], parts.length).maxCoeff()
              : 1.0;
      loudest = std::max(loudest, parts.power[c][i] / (known * usual[c]));
    }
    if (loudest > kLoud) out.push_back(signals.blockTime(parts.from[i]));
  }
  return out;
}

bool noiseSwitches(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  const Parts parts = partsOf(signals, stretches, fit);
  const std::size_t count = parts.from.size();
  if (std::cmp_less(count, kFewestSamples)) return false;
  const Eigen::Index m = signals.samplesPerBlock;
  // Noise that grows with the motion, however that is measured, is alike in parts next to one another.
  std::array<std::vector<std::pair<double, std::size_t>>, 3> orders;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Index from = parts.from[i] * m, length = parts.length * m;
    const auto mean = [&](const auto& of) { return of.middleCols(from, length).colwise().norm().mean(); };
    double accelerates = 0.0;
    for (Eigen::Index k = from; k < from + length; ++k)
      accelerates += (signals.kinematics.specificForce.col(k) +
                      signals.R_BS[static_cast<std::size_t>(k)].transpose() * signals.gravity)
                         .norm();
    orders[0].emplace_back(mean(signals.velocity) + kGrip * mean(signals.kinematics.omega), i);
    orders[1].emplace_back(accelerates, i);
    orders[2].emplace_back(mean(signals.kinematics.alpha), i);
  }
  for (auto& order : orders) std::ranges::sort(order);
  return std::ranges::any_of(parts.power, [&](const std::vector<double>& power) {
    return std::ranges::all_of(orders, [&](const auto& order) {
      std::size_t far = 0;
      for (std::size_t i = 1; i < count; ++i) {
        const double one = power[order[i - 1].second], other = power[order[i].second];
        far += std::max(one, other) > kStandsOut * std::min(one, other) ? 1 : 0;
      }
      return static_cast<double>(far) > kMinorShare * static_cast<double>(count - 1);
    });
  });
}

std::optional<double> glitchIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  /// Squared deviations of six channels. In 96 clean recordings 58 at most; where a sign was wrong for 30 ms, 90,000.
  constexpr double kFar = 500.0;
  const VectorXd innovations = whitened(flat(fit.residual), fit.noise, stretches);
  const Eigen::Map<const Wrenches> e(innovations.data(), 6, fit.residual.cols());
  const Vector6d usual = (1.4826 * mediansIn(e.cwiseAbs(), stretches)).cwiseAbs2().cwiseMax(1e-12);
  double most = kFar;
  std::optional<double> out;
  for (const auto& s : stretches)
    for (Eigen::Index n = s.from; n < s.to; ++n) {
      const double size = e.col(n).cwiseAbs2().cwiseQuotient(knownAt(signals, usual, n)).sum();
      if (size <= most) continue;
      most = size;
      out = signals.blockTime(n);
    }
  return out;
}

}  // namespace heft::diagnosis
