#pragma once
// How a stretch's power is spread over frequency.
#include <Eigen/Core>

namespace heft {

/// |X_k|^2 / sum w^2 of each row of `x` (C x L, a column an instant), its mean taken off, under a Hann taper w, at k
/// cycles over the length, k = 1 .. lines < L: C x lines.
Eigen::MatrixXd taperedPower(const Eigen::MatrixXd& x, Eigen::Index lines);

/// X_k = sum_n x_n exp(-2 pi i k n / length) of each of `columns` (N x C, a row an instant), k = 0 .. length - 1:
/// length x C. `length` >= N: zeros follow.
Eigen::MatrixXcd paddedSpectrum(const Eigen::MatrixXd& columns, Eigen::Index length);

/// The least length from `least` on that has no prime factors but 2, 3 and 5: transforms of it are fast.
Eigen::Index lengthOfEasyFactors(Eigen::Index least);

}  // namespace heft
