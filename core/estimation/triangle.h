#pragma once
// From rows to the compressed problem, and what can be asked of it.
#include <algorithm>
#include <vector>

#include "core/estimation/linear_problem.h"
#include "core/wrench/rows.h"

namespace heft {

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

}  // namespace heft
