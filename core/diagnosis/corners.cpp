#include "core/diagnosis/corners.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/statistics.h"

namespace heft::diagnosis {

void leaveOutCorners(Way& way, const Way& smoother) {
  constexpr double kNoise = 3.0, kUsual = 6.0;  // Deviations of the noise; times what is usual
  constexpr double kMostShare = 0.3;
  Signals& signals = way.signals;
  const Eigen::Index blocks = signals.blocks();
  const auto stretches = untouched(signals, way);
  if (stretches.empty() || smoother.signals.size() != signals.size()) return;
  const Fit fit = fitModel(signals, stretches, Model{});
  const Vector10d payload = fit.model.x.tail<10>();
  const Wrenches differs = averaged(signals, payloadWrench(signals.kinematics, payload) - payloadWrench(smoother.signals.kinematics, payload));
  Eigen::VectorXd most = Eigen::VectorXd::Zero(blocks);
  for (Eigen::Index c = 0; c < 6; ++c) {
    std::vector<double> left, moved;
    for (const auto& s : stretches)
      for (Eigen::Index n = s.from; n < s.to; ++n) {
        left.push_back(std::abs(fit.residual(c, n)));
        moved.push_back(std::abs(differs(c, n)));
      }
    const double limit = std::max({1e-9, kNoise * 1.4826 * median(std::move(left)), kUsual * 1.4826 * median(std::move(moved))});
    most = most.cwiseMax(differs.row(c).transpose().cwiseAbs() / limit);
  }
  std::vector<Eigen::Index> corners;
  for (Eigen::Index n = 0; n < blocks; ++n)
    if (most(n) > 1.0 && signals.usable[static_cast<std::size_t>(n)]) corners.push_back(n);
  if (static_cast<double>(corners.size()) > kMostShare * static_cast<double>(blocks)) return;
  for (const Eigen::Index corner : corners)
    for (Eigen::Index n = std::max<Eigen::Index>(0, corner - 1); n < std::min(blocks, corner + 2); ++n) signals.usable[static_cast<std::size_t>(n)] = false;
}

}  // namespace heft::diagnosis
