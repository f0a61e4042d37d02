#include "core/diagnosis/model/compact_columns.h"

namespace heft::diagnosis {

namespace {

using EverySixth = Eigen::InnerStride<6>;

}  // namespace

CompactColumns::CompactColumns(const Eigen::Ref<const MatrixXd>& dense) : columns_(dense.cols()) {
  const Eigen::Index blocks = dense.rows() / 6;
  const auto channelOf = [&](const Place& p) {
    return Eigen::Map<const VectorXd, 0, EverySixth>(dense.col(p.column).data() + p.channel, blocks);
  };
  for (Place p; p.column < columns_; ++p.column)
    for (p.channel = 0; p.channel < 6; ++p.channel)
      if (!channelOf(p).isZero(0.0)) places_.push_back(p);
  values_.resize(blocks, std::ssize(places_));
  for (Eigen::Index i = 0; i < values_.cols(); ++i) values_.col(i) = channelOf(places_[static_cast<std::size_t>(i)]);
}

MatrixXd CompactColumns::dense() const {
  MatrixXd out = MatrixXd::Zero(rows(), columns_);
  for (Eigen::Index i = 0; i < values_.cols(); ++i) {
    const Place& p = places_[static_cast<std::size_t>(i)];
    Eigen::Map<VectorXd, 0, EverySixth>(out.col(p.column).data() + p.channel, values_.rows()) = values_.col(i);
  }
  return out;
}

VectorXd CompactColumns::times(const VectorXd& v) const {
  VectorXd out = VectorXd::Zero(rows());
  for (Eigen::Index i = 0; i < values_.cols(); ++i) {
    const Place& p = places_[static_cast<std::size_t>(i)];
    if (v(p.column) != 0.0)
      Eigen::Map<VectorXd, 0, EverySixth>(out.data() + p.channel, values_.rows()) += v(p.column) * values_.col(i);
  }
  return out;
}

}  // namespace heft::diagnosis
