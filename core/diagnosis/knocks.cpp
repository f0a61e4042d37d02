#include "core/diagnosis/knocks.h"

#include <algorithm>
#include <array>
#include <cmath>

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
  if (signals.louder) usual.array() *= 1.0 + signals.louder->times().col(n).array();
  return usual;
}

}  // namespace

std::vector<double> knocksIn(const Signals& signals, const std::vector<Stretch>& stretches, const Model& model) {
  /// Times the usual power beside a straight line through each block. Of 260 recordings 255 have none at 15, the others
  /// some, such as where friction turns round; three and more at 60 had only a part that rattled.
  constexpr double kLoud = 60.0;
  constexpr double kRings = 0.3;  ///< [s]
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
      if (loud > kLoud && (out.empty() || t > out.back() + kRings)) out.push_back(t);
    }
  return out;
}

std::vector<double> burstsIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  /// Times the usual power. Of 1,440 recordings, the third loudest part of those with nothing of the kind had 6.2
  /// at most; where something rang again and again, 25 (our own test: 7 to 9).
  constexpr double kLoud = 7.0;
  const auto length = static_cast<Eigen::Index>(std::max(3.0, std::round(0.3 * signals.blockRate())));
  const VectorXd innovations = whitened(flat(fit.residual), fit.noise, stretches);
  const Eigen::Map<const Wrenches> e(innovations.data(), 6, fit.residual.cols());
  std::vector<Eigen::Index> at;
  std::array<std::vector<double>, 6> power;
  for (const auto& s : stretches)
    for (Eigen::Index n = s.from; n + length <= s.to; n += length) {
      at.push_back(n);
      for (Eigen::Index c = 0; c < 6; ++c)
        power[static_cast<std::size_t>(c)].push_back(e.row(c).segment(n, length).squaredNorm());
    }
  std::vector<double> out;
  if (at.empty()) return out;
  std::array<double, 6> usual;
  for (std::size_t c = 0; c < 6; ++c) usual[c] = std::max(1e-12, median(power[c]));
  for (std::size_t i = 0; i < at.size(); ++i) {
    double loudest = 0.0;
    for (std::size_t c = 0; c < 6; ++c) {
      const auto row = static_cast<Eigen::Index>(c);
      const double known =
          signals.louder ? 1.0 + signals.louder->times().row(row).segment(at[i], length).maxCoeff() : 1.0;
      loudest = std::max(loudest, power[c][i] / (known * usual[c]));
    }
    if (loudest > kLoud) out.push_back(signals.blockTime(at[i]));
  }
  return out;
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
