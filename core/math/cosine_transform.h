#pragma once
// The orthonormal discrete cosine transform of any length, in O(N log N).
#include <Eigen/Core>
#include <complex>
#include <vector>

namespace heft {

/// DCT-II of N samples: X_k = s_k sum_n x_n cos(pi k (n + 1/2) / N), s_0 = sqrt(1/N), s_k = sqrt(2/N), as a convolution
/// with a chirp (Bluestein, 1970). Threads may share it.
class CosineTransform {
 public:
  explicit CosineTransform(Eigen::Index count);
  /// Of each column of `samples` (N x C): N x C.
  Eigen::MatrixXd forward(const Eigen::MatrixXd& samples) const;
  /// What `forward` makes `waves` (N x C) of.
  Eigen::MatrixXd inverse(const Eigen::MatrixXd& waves) const;

 private:
  using Complex = std::complex<double>;
  /// sum_m values_m exp(-i pi m k / N), k = 0 .. N - 1.
  std::vector<Complex> halfTurns(const std::vector<Complex>& values) const;

  std::size_t count_;
  std::vector<Complex> chirp_;     ///< exp(-i pi n^2 / 2N)
  std::vector<Complex> spectrum_;  ///< Of the conjugate chirp from -N to N, in a ring of a power of two
};

}  // namespace heft
