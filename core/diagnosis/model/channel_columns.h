#pragma once
// Whitened columns, and what is made of them: products.
#include <array>
#include <vector>

#include "core/diagnosis/model/noise.h"

namespace heft::diagnosis {

/// Whitened columns (6N rows), kept channel by channel: many of them, such as biases and waves of the zero, are about
/// one channel only, and cost a sixth.
class ChannelColumns {
 public:
  /// `columns`: 6N rows of the blocks from `first` on, not yet whitened.
  ChannelColumns(const MatrixXd& columns, const Noise& noise, const std::vector<Stretch>& stretches,
                 Eigen::Index first = 0);

  Eigen::Index cols() const { return columns_; }
  MatrixXd gram() const;                    ///< J^T J
  VectorXd times(const VectorXd& v) const;  ///< J v, 6N
  /// J^T C, where C is of the blocks from `from` on and what J has beyond its end is left out.
  MatrixXd transposeTimes(const ChannelColumns& C, Eigen::Index from) const;
  /// J^T C of whitened columns with 6N rows.
  MatrixXd transposeTimes(const MatrixXd& C) const;

 private:
  Eigen::Index columns_ = 0, blocks_ = 0;
  std::array<MatrixXd, 6> parts_;  ///< N x what is not zero in the channel
  std::array<std::vector<Eigen::Index>, 6> which_;
};

}  // namespace heft::diagnosis
