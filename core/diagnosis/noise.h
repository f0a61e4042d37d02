#pragma once
// What is left when a model is right: autoregressive noise in each channel, and how probable it makes a residual.
#include <array>

#include "core/diagnosis/signals.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

/// A stretch of usable blocks: [from, to).
struct Stretch {
  Eigen::Index from = 0, to = 0;
};

/// Stretches of at least 12 usable blocks.
std::vector<Stretch> stretchesOf(const std::vector<bool>& usable);

struct Noise {
  std::array<ArModel, 6> channels;
  /// Twice the log-likelihood of the residual it was fitted to, minus ln n for each coefficient of the noise.
  double evidence = 0.0;
  double samples = 0.0;  ///< n: numbers judged, all channels together
};

Noise fitNoise(const Wrenches& residual, const std::vector<Stretch>& stretches);

/// The same sizes without memory.
Noise white(const Wrenches& residual, const std::vector<Stretch>& stretches);

/// Columns of 6N rows (row 6 n + channel) turned into unit innovations; rows that are not judged become zero.
MatrixXd whitened(const MatrixXd& columns, const Noise& noise, const std::vector<Stretch>& stretches);

}  // namespace heft::diagnosis
