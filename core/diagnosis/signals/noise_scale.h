#pragma once
// Where noise may be louder than usual, by how much, and what that makes of the weight of a reading.
#include <array>

#include <Eigen/Core>

namespace heft::diagnosis {

/// Noise whose power is 1 + share times(c, n) of the usual in channel c and block n; of the share only so much is
/// known: it is one of a few.
class NoiseScale {
 public:
  using Blocks = Eigen::Matrix<double, 6, Eigen::Dynamic>;
  using ByChannel = Eigen::Matrix<double, Eigen::Dynamic, 6>;

  /// `times`: 6 x N, zero where noise is as usual.
  explicit NoiseScale(Blocks times);

  struct Level {
    double share = 0.0;
    Blocks by;            ///< 6 x N: what makes all blocks equally loud, 1 / sqrt(1 + share times)
    ByChannel byChannel;  ///< Its transpose
    ByChannel logs;       ///< N x 6: ln(1 + share times)
  };

  const Blocks& times() const { return times_; }
  const std::array<Level, 4>& levels() const { return levels_; }

 private:
  Blocks times_;
  std::array<Level, 4> levels_;  ///< Rising shares
};

}  // namespace heft::diagnosis
