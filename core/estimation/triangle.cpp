#include "core/estimation/triangle.h"

namespace heft {

TriangleBuilder::TriangleBuilder() : buffer_(kChunk + kColumns + 1, kColumns + 1) {}

void TriangleBuilder::add(const Eigen::Ref<const Eigen::Matrix<double, 1, kColumns + 1>>& row) {
  buffer_.row(filled_++) = row;
  ++rows_;
  if (filled_ == buffer_.rows()) compress();
}

void TriangleBuilder::compress() {
  const Eigen::HouseholderQR<MatrixXd> qr(buffer_.topRows(filled_));
  const Eigen::Index height = std::min<Eigen::Index>(filled_, kColumns + 1);
  buffer_.topRows(height) = qr.matrixQR().topRows(height).triangularView<Eigen::Upper>();
  filled_ = height;
}

Triangle TriangleBuilder::finish() {
  if (filled_ > 0) compress();
  Triangle R = Triangle::Zero();
  R.topRows(filled_) = buffer_.topRows(filled_);
  return R;
}

Triangle merged(const std::vector<Triangle>& parts) {
  TriangleBuilder builder;
  for (const auto& part : parts)
    for (int i = 0; i <= kColumns; ++i) builder.add(part.row(i));
  return builder.finish();
}

Eigen::Matrix<double, 6, kColumns + 1> blockRows(const WrenchRows& rows, Eigen::Index k) {
  Eigen::Matrix<double, 6, kColumns + 1> A;
  A.leftCols<6>().setIdentity();
  A.middleCols<10>(6) = rows.Y[static_cast<std::size_t>(k)];
  A.col(kColumns) = rows.wrench.col(k);
  return A;
}

ReducedProblem reduced(const Triangle& R, const MatrixXd& map, const VectorXd& offset, Eigen::Index rowCount) {
  const Eigen::Index d = map.cols();
  MatrixXd stacked(kColumns + 1, d + 1);
  stacked.leftCols(d) = R.leftCols<kColumns>() * map;
  stacked.col(d) = R.col(kColumns) - R.leftCols<kColumns>() * offset;
  const MatrixXd triangle =
      Eigen::HouseholderQR<MatrixXd>(stacked).matrixQR().topRows(d + 1).triangularView<Eigen::Upper>();
  return {triangle.leftCols(d), triangle.col(d), map, offset, rowCount};
}

ReducedProblem reducedRows(const Rows& rows, const MatrixXd& map, const VectorXd& offset) {
  return {rows.leftCols<kColumns>() * map, rows.col(kColumns) - rows.leftCols<kColumns>() * offset, map, offset,
          rows.rows()};
}

}  // namespace heft
