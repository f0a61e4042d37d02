#pragma once
// Bringing irregular samples onto one uniform grid.
#include <array>

#include "core/motion/low_pass.h"

namespace heft {

struct UniformGrid {
  double start = 0.0;  ///< [s]
  double rateHz = 0.0;
  Eigen::Index size = 0;
  bool exact = false;  ///< The samples lie on the grid to a hundredth of a step: nothing is interpolated.
};

/// The grid with the median time step that spans `time` (strictly rising, at least two samples).
UniformGrid gridFor(const VectorXd& time);

/// A row of a matrix of any order.
using Row = Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>>;

/// `out` becomes the value at `t` by Lagrange's polynomial through four `rows` of `values`; it may be another of their
/// rows.
void interpolate(const std::array<Eigen::Index, 4>& rows, double t, const VectorXd& time,
                 const Eigen::Ref<const MatrixXd>& values, Row out);

/// Values on the grid: cubic Lagrange interpolation through the samples before and after, and beyond each the next that
/// is at least half as far away as they are apart; linear over more than half a second, and at the ends. A line would
/// make what vibrates smaller: of 10 Hz sampled each 10 ms by 3 %, and a mass with it. Rows of `values` belong to
/// `time`. The rows [from, to) of the grid, or all of them.
Channels onGrid(const UniformGrid& grid, const VectorXd& time, const Eigen::Ref<const MatrixXd>& values,
                Eigen::Index from, Eigen::Index to);
Channels onGrid(const UniformGrid& grid, const VectorXd& time, const Eigen::Ref<const MatrixXd>& values);

}  // namespace heft
