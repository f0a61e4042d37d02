#pragma once
// Columns of wrenches, kept channel by channel: as they are, and whitened.
#include <array>
#include <memory>
#include <vector>

#include "core/diagnosis/model/noise.h"

namespace heft::diagnosis {

/// A wrench a block, kept without the channels in which it is zero: many columns, such as those of zeros, gains and
/// waves, are about one channel alone and take a sixth.
class ChannelColumn {
 public:
  /// `wrench`: 6 x N.
  explicit ChannelColumn(const Eigen::Ref<const Wrenches>& wrench, double factor = 1.0);
  /// Of one channel.
  ChannelColumn(std::size_t channel, VectorXd values);

  Eigen::Index blocks() const { return blocks_; }
  bool isZero(std::size_t channel) const { return at_[channel] < 0; }
  /// Of a channel that is not zero, N.
  auto channel(std::size_t channel) const { return values_.segment(at_[channel], blocks_); }
  /// The blocks outside of which all is zero.
  Stretch support() const;
  ChannelColumn middle(Stretch blocks) const;
  /// 6N, row 6 n + channel.
  VectorXd dense() const;

 private:
  ChannelColumn() = default;

  Eigen::Index blocks_ = 0;
  std::array<Eigen::Index, 6> at_{};  ///< Where the channel begins in values_; -1: it is zero
  VectorXd values_;
};

/// Columns of equally many blocks. Copies share them: fits of one search have most of theirs in common.
class ChannelColumns {
 public:
  ChannelColumns() = default;
  /// As many that are all zero.
  ChannelColumns(Eigen::Index blocks, Eigen::Index columns);
  /// `dense`: 6N rows, row 6 n + channel.
  explicit ChannelColumns(const MatrixXd& dense);

  Eigen::Index blocks() const { return blocks_; }
  Eigen::Index cols() const { return std::ssize(columns_); }
  const ChannelColumn& column(Eigen::Index i) const { return *columns_[static_cast<std::size_t>(i)]; }
  void set(Eigen::Index i, ChannelColumn column);
  /// More of them, all zero.
  void grow(Eigen::Index columns);

  Stretch support() const;
  ChannelColumns middle(Stretch blocks) const;
  /// 6N x cols().
  MatrixXd dense() const;
  /// dense() * v.
  VectorXd times(const VectorXd& v) const;

 private:
  Eigen::Index blocks_ = 0;
  std::vector<std::shared_ptr<const ChannelColumn>> columns_;
};

/// Unit innovations of columns, of the judged blocks alone.
class WhitenedColumns {
 public:
  /// `columns`: of the blocks from `first` on.
  WhitenedColumns(const ChannelColumns& columns, const Noise& noise, const std::vector<Stretch>& stretches,
                  Eigen::Index first = 0);
  /// `white`: columns of 6N rows that are such innovations already; what is not judged is left out.
  static WhitenedColumns ofWhite(const MatrixXd& white, const Noise& noise, const std::vector<Stretch>& stretches);

  Eigen::Index cols() const { return columns_; }
  MatrixXd gram() const;                    ///< J^T J
  VectorXd times(const VectorXd& v) const;  ///< J v, 6N
  /// J^T C, where C is whitened by the same noise and of no more blocks.
  MatrixXd transposeTimes(const WhitenedColumns& C) const;
  /// J^T C of whitened columns with 6N rows.
  MatrixXd transposeTimes(const MatrixXd& C) const;

 private:
  /// Judged blocks without a gap, and their first row in the channel's part.
  struct Run {
    Eigen::Index from, count, row;
  };

  WhitenedColumns(Eigen::Index columns, Eigen::Index blocks, Eigen::Index first, const Noise& noise,
                  const std::vector<Stretch>& stretches);
  Eigen::Index rows(std::size_t channel) const;
  MatrixXd judged(const MatrixXd& C, std::size_t channel) const;

  Eigen::Index columns_ = 0, blocks_ = 0, first_ = 0;
  std::array<std::vector<Run>, 6> runs_;
  std::array<MatrixXd, 6> parts_;  ///< Judged blocks x what is not zero in the channel
  std::array<std::vector<Eigen::Index>, 6> which_;
};

}  // namespace heft::diagnosis
