#pragma once
// The compressed problem: a 17 x 17 triangle that holds everything a least-squares solver needs to know about all rows.
#include <algorithm>
#include <vector>

#include "core/math/rigid.h"
#include "core/wrench/rows.h"

namespace heft {

/// Columns of the linear problem A x = y with x = [bias force, bias torque, phi]: the biases stand first, so that the
/// trailing 11 x 11 block is the problem with the biases already eliminated.
constexpr int kBiasColumns = 6;
constexpr int kColumns = 16;

using Matrix10d = Eigen::Matrix<double, 10, 10>;
using Triangle = Eigen::Matrix<double, kColumns + 1, kColumns + 1>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, kColumns + 1, Eigen::RowMajor>;

/// Accumulates rows [A | y] into the upper triangle R with R^T R = [A|y]^T [A|y] by Householder reflections on chunks
/// that stay in the processor's first cache: exact to rounding, in constant memory.
class TriangleBuilder {
 public:
  /// Any number of rows, 17 columns.
  template <class Derived>
  void add(const Eigen::MatrixBase<Derived>& rows) {
    if constexpr (Derived::RowsAtCompileTime == kBlock) {
      if (filled_ % kBlock == 0) {  // Which never go beyond the chunk's end
        chunk_.template middleRows<kBlock>(filled_) = rows;
        rows_ += kBlock;
        filled_ += kBlock;
        if (filled_ == kChunk) compress();
        return;
      }
    }
    for (Eigen::Index from = 0; from < rows.rows();) {
      const Eigen::Index count = std::min(kChunk - filled_, rows.rows() - from);
      chunk_.middleRows(filled_, count) = rows.middleRows(from, count);
      filled_ += count;
      from += count;
      if (filled_ == kChunk) compress();
    }
    rows_ += rows.rows();
  }
  Triangle finish();
  Eigen::Index rows() const { return rows_; }

 private:
  void compress();
  static constexpr int kBlock = 6;
  static constexpr Eigen::Index kChunk = Eigen::Index{28} * kBlock;
  Eigen::Matrix<double, kChunk, kColumns + 1> chunk_;
  Triangle R_ = Triangle::Zero();  ///< Of the rows before the chunk.
  Eigen::Index filled_ = 0;
  Eigen::Index rows_ = 0;
};

/// Triangle of several triangles.
Triangle merged(const std::vector<Triangle>& parts);

/// All six rows of block k as [bias | Y | y].
Eigen::Matrix<double, 6, kColumns + 1> blockRows(const WrenchRows& rows, Eigen::Index k);

/// A linear least-squares problem min |A z - y| after known values were put in: x = offset + map * z.
/// Compressed it has at most 17 rows, otherwise all of them.
struct ReducedProblem {
  MatrixXd A;
  VectorXd y;
  MatrixXd map;               ///< 16 x d
  VectorXd offset;            ///< 16
  Eigen::Index rowCount = 0;  ///< Rows behind it, for degrees of freedom.

  VectorXd full(const VectorXd& z) const { return offset + map * z; }
};

/// Puts x = offset + map z into the triangle (or into all rows) and, for a triangle, makes it upper triangular again.
ReducedProblem reduced(const Triangle& R, const MatrixXd& map, const VectorXd& offset, Eigen::Index rowCount);
ReducedProblem reducedRows(const Rows& rows, const MatrixXd& map, const VectorXd& offset);

}  // namespace heft
