#pragma once
// How a stretch's power is spread over frequency.
#include <Eigen/Core>

namespace heft {

/// |X_k|^2 / sum w^2 of each row of `x` (C x L, a column an instant), its mean taken off, under a Hann taper w, at k
/// cycles over the length, k = 1 .. lines: C x lines.
Eigen::MatrixXd taperedPower(const Eigen::MatrixXd& x, Eigen::Index lines);

}  // namespace heft
