#include "core/diagnosis/model/channel_columns.h"

#include "core/base/parallel.h"

namespace heft::diagnosis {

ChannelColumns::ChannelColumns(const MatrixXd& columns, const Noise& noise, const std::vector<Stretch>& stretches,
                               Eigen::Index first)
    : columns_(columns.cols()), blocks_(columns.rows() / 6) {
  for (std::size_t c = 0; c < 6; ++c) {
    parts_[c].resize(blocks_, columns_);
    which_[c].reserve(static_cast<std::size_t>(columns_));
  }
  // Which are of a channel is not known before they are looked at: first all side by side.
  std::vector<std::array<bool, 6>> any(static_cast<std::size_t>(columns_));
  parallelFor(any.size(), [&](std::size_t at) {
    const auto i = static_cast<Eigen::Index>(at);
    ByChannel x(blocks_, 6);
    evenByChannel(columns.col(i), noise, first, x);
    for (std::size_t c = 0; c < 6; ++c) {
      const auto channel = x.col(static_cast<Eigen::Index>(c));
      if (channel.isZero(0.0)) continue;
      innovate(channel, noise, c, stretches, first, parts_[c].col(i));
      any[at][c] = true;
    }
  });
  for (std::size_t c = 0; c < 6; ++c) {
    for (Eigen::Index i = 0; i < columns_; ++i) {
      if (!any[static_cast<std::size_t>(i)][c]) continue;
      if (std::ssize(which_[c]) < i) parts_[c].col(std::ssize(which_[c])) = parts_[c].col(i);
      which_[c].push_back(i);
    }
    parts_[c].conservativeResize(Eigen::NoChange, std::ssize(which_[c]));
  }
}

MatrixXd ChannelColumns::gram() const {
  std::array<MatrixXd, 6> parts;
  parallelFor(6, [&](std::size_t c) {
    parts[c] = MatrixXd::Zero(parts_[c].cols(), parts_[c].cols());
    parts[c].selfadjointView<Eigen::Lower>().rankUpdate(parts_[c].transpose());
  });
  MatrixXd out = MatrixXd::Zero(columns_, columns_);
  for (std::size_t c = 0; c < 6; ++c) out(which_[c], which_[c]) += MatrixXd(parts[c].selfadjointView<Eigen::Lower>());
  return out;
}

VectorXd ChannelColumns::times(const VectorXd& v) const {
  VectorXd out(6 * blocks_);
  Eigen::Map<Wrenches> channels(out.data(), 6, blocks_);
  for (std::size_t c = 0; c < 6; ++c)
    channels.row(static_cast<Eigen::Index>(c)) = (parts_[c] * v(which_[c])).transpose();
  return out;
}

MatrixXd ChannelColumns::transposeTimes(const ChannelColumns& C, Eigen::Index from) const {
  MatrixXd out = MatrixXd::Zero(columns_, C.columns_);
  for (std::size_t c = 0; c < 6; ++c)
    out(which_[c], C.which_[c]) += parts_[c].middleRows(from, C.blocks_).transpose() * C.parts_[c];
  return out;
}

MatrixXd ChannelColumns::transposeTimes(const MatrixXd& C) const {
  MatrixXd out = MatrixXd::Zero(columns_, C.cols());
  MatrixXd part(blocks_, C.cols());
  for (std::size_t c = 0; c < 6; ++c) {
    for (Eigen::Index i = 0; i < C.cols(); ++i)
      part.col(i) = Eigen::Map<const VectorXd, 0, Eigen::InnerStride<6>>(C.col(i).data() + c, blocks_);
    out(which_[c], Eigen::all) += parts_[c].transpose() * part;
  }
  return out;
}

}  // namespace heft::diagnosis
