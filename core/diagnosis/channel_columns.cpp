#include "core/diagnosis/channel_columns.h"

namespace heft::diagnosis {

ChannelColumns::ChannelColumns(const MatrixXd& columns, const Noise& noise, const std::vector<Stretch>& stretches,
                               Eigen::Index first)
    : columns_(columns.cols()), blocks_(columns.rows() / 6) {
  for (std::size_t c = 0; c < 6; ++c) {
    parts_[c].resize(blocks_, columns_);
    which_[c].reserve(static_cast<std::size_t>(columns_));
  }
  ByChannel x(blocks_, 6);
  for (Eigen::Index i = 0; i < columns_; ++i) {
    evenByChannel(columns.col(i), noise, first, x);
    for (std::size_t c = 0; c < 6; ++c) {
      const auto channel = x.col(static_cast<Eigen::Index>(c));
      if (channel.isZero(0.0)) continue;
      innovate(channel, noise, c, stretches, first, parts_[c].col(std::ssize(which_[c])));
      which_[c].push_back(i);
    }
  }
  for (std::size_t c = 0; c < 6; ++c) parts_[c].conservativeResize(Eigen::NoChange, std::ssize(which_[c]));
}

MatrixXd ChannelColumns::gram() const {
  MatrixXd out = MatrixXd::Zero(columns_, columns_);
  for (std::size_t c = 0; c < 6; ++c) {
    MatrixXd part = MatrixXd::Zero(parts_[c].cols(), parts_[c].cols());
    part.selfadjointView<Eigen::Lower>().rankUpdate(parts_[c].transpose());
    out(which_[c], which_[c]) += MatrixXd(part.selfadjointView<Eigen::Lower>());
  }
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
