#include "core/diagnosis/model/channel_columns.h"

#include "core/base/parallel.h"

namespace heft::diagnosis {

ChannelColumns::ChannelColumns(const MatrixXd& columns, const Noise& noise, const std::vector<Stretch>& stretches,
                               Eigen::Index first)
    : columns_(columns.cols()), blocks_(columns.rows() / 6) {
  std::vector<std::array<Eigen::Index, 6>> place(static_cast<std::size_t>(columns_));  // In its part; -1: it is zero
  parallelFor(place.size(), [&](std::size_t i) {
    const Eigen::Map<const Wrenches> channels(columns.col(static_cast<Eigen::Index>(i)).data(), 6, blocks_);
    const Vector6d most = channels.cwiseAbs().rowwise().maxCoeff();
    for (std::size_t c = 0; c < 6; ++c) place[i][c] = most(static_cast<Eigen::Index>(c)) == 0.0 ? -1 : 0;
  });
  for (std::size_t c = 0; c < 6; ++c) {
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (place[i][c] < 0) continue;
      place[i][c] = std::ssize(which_[c]);
      which_[c].push_back(static_cast<Eigen::Index>(i));
    }
    parts_[c].resize(blocks_, std::ssize(which_[c]));
  }
  parallelFor(place.size(), [&](std::size_t i) {
    ByChannel x(blocks_, 6);
    evenByChannel(columns.col(static_cast<Eigen::Index>(i)), noise, first, x);
    for (std::size_t c = 0; c < 6; ++c)
      if (place[i][c] >= 0)
        innovate(x.col(static_cast<Eigen::Index>(c)), noise, c, stretches, first, parts_[c].col(place[i][c]));
  });
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
