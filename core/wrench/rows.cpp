#include "core/wrench/rows.h"

#include <algorithm>
#include <cmath>

namespace heft {

WrenchRows rowsOf(const Motion& motion, double rateHz) {
  WrenchRows rows;
  rows.samplesPerBlock = rateHz > 0.0 ? std::max(1, static_cast<int>(std::lround(motion.rateHz / rateHz))) : 1;
  const int n = rows.samplesPerBlock;
  const Eigen::Index blocks = motion.size() / n;
  rows.rateHz = motion.rateHz / n;
  rows.startTime = motion.startTime + 0.5 * (n - 1) / motion.rateHz;
  rows.Y.resize(static_cast<std::size_t>(blocks));
  rows.wrench.resize(6, blocks);
  for (Eigen::Index b = 0; b < blocks; ++b) {
    Regressor& Y = rows.Y[static_cast<std::size_t>(b)];
    Y.setZero();
    for (Eigen::Index k = b * n; k < (b + 1) * n; ++k)
      Y += regressor({motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)});
    Y /= n;
    rows.wrench.col(b) = motion.wrench.middleCols(b * n, n).rowwise().mean();
  }
  return rows;
}

}  // namespace heft
