#include "core/estimation/triangle.h"

#include <cmath>

#include "core/math/linear_algebra.h"

namespace heft {

void TriangleBuilder::compress() {
  // Below the triangle each column of [R; chunk] holds the chunk only, so that a reflector touches one row of R.
  Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kColumns> w;
  for (Eigen::Index j = 0; j <= kColumns; ++j) {
    const auto v = chunk_.col(j).head(filled_);
    const double below = v.squaredNorm();
    if (below == 0.0) continue;
    const double diagonal = R_(j, j);
    const double norm = std::hypot(diagonal, std::sqrt(below));
    const double beta = diagonal > 0.0 ? -norm : norm;
    const double head = diagonal - beta;  // H = I + u u^T / (beta head) with u = [head; v]
    const Eigen::Index right = kColumns - j;
    if (right > 0) {
      auto rest = chunk_.topRightCorner(filled_, right);
      w.noalias() = v.transpose() * rest;
      w = (w + head * R_.row(j).tail(right)) / (beta * head);
      R_.row(j).tail(right) += head * w;
      rest.noalias() += v * w;
    }
    R_(j, j) = beta;
  }
  filled_ = 0;
}

Triangle TriangleBuilder::finish() {
  compress();
  return R_;
}

Triangle merged(const std::vector<Triangle>& parts) {
  TriangleBuilder builder;
  for (const auto& part : parts) builder.add(part);
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
  stacked.leftCols(d) = product(R.leftCols<kColumns>(), map);
  stacked.col(d) = R.col(kColumns) - R.leftCols<kColumns>() * offset;
  const MatrixXd triangle = upperTriangle(stacked);
  return {triangle.leftCols(d), triangle.col(d), map, offset, rowCount};
}

ReducedProblem reducedRows(const Rows& rows, const MatrixXd& map, const VectorXd& offset) {
  return {product(rows.leftCols<kColumns>(), map), rows.col(kColumns) - rows.leftCols<kColumns>() * offset, map, offset,
          rows.rows()};
}

}  // namespace heft
