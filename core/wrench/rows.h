#pragma once
// Regressor rows of a motion, averaged into blocks.
#include <vector>

#include "core/motion/motion.h"
#include "core/wrench/regressor.h"

namespace heft {

/// K instants: y_k = Y_k phi + bias + noise, both averaged over the same `samplesPerBlock` motion samples.
struct WrenchRows {
  double startTime = 0.0;  ///< Centre of the first block [s]
  double rateHz = 0.0;
  int samplesPerBlock = 1;
  std::vector<Regressor> Y;
  Eigen::Matrix<double, 6, Eigen::Dynamic> wrench;  ///< F_PSo_S [N, N m]

  Eigen::Index size() const { return wrench.cols(); }
  double time(Eigen::Index k) const { return startTime + static_cast<double>(k) / rateHz; }
};

/// Blocks of about 1/rateHz seconds (0: no averaging). A remainder at the end is dropped.
WrenchRows rowsOf(const Motion& motion, double rateHz);

}  // namespace heft
