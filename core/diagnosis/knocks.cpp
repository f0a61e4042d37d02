#include "core/diagnosis/knocks.h"

#include "core/math/statistics.h"

namespace heft::diagnosis {

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
  Vector6d usual;
  for (Eigen::Index c = 0; c < 6; ++c) {
    std::vector<double> all;
    for (const auto& s : stretches)
      for (Eigen::Index n = s.from; n < s.to; ++n) all.push_back(power(c, n));
    usual(c) = std::max(1e-12, median(all));
  }
  std::vector<double> out;
  for (const auto& s : stretches)
    for (Eigen::Index n = s.from; n < s.to; ++n) {
      Vector6d most = usual;  // Where the motion turns sharply, it makes knocks of its own
      if (signals.louder) most.array() *= 1.0 + signals.louder->times().col(n).array();
      const double loud = power.col(n).cwiseQuotient(most).mean(), t = signals.blockTime(n);
      if (loud > kLoud && (out.empty() || t > out.back() + kRings)) out.push_back(t);
    }
  return out;
}

}  // namespace heft::diagnosis
