#pragma once
// The linear problem's columns and its compressed form: a 17 x 17 triangle that holds everything a least-squares solver
// needs to know about all rows.
#include "core/math/rigid.h"

namespace heft {

/// Columns of the linear problem A x = y with x = [bias force, bias torque, phi]: the biases stand first, so that the
/// trailing 11 x 11 block is the problem with the biases already eliminated.
constexpr int kBiasColumns = 6;
constexpr int kColumns = 16;

/// Upper triangle R with R^T R = [A|y]^T [A|y].
using Triangle = Eigen::Matrix<double, kColumns + 1, kColumns + 1>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, kColumns + 1, Eigen::RowMajor>;

}  // namespace heft
