#pragma once
// Products and sums of long columns, four rows at a time: several times as fast as what is compiled for every
// processor, and the same to the last digit on all of them.
#include <span>

#include "core/math/rigid.h"

namespace heft {

/// A^T B of tall matrices: n x p and n x q to p x q.
MatrixXd columnProducts(const Eigen::Ref<const MatrixXd>& A, const Eigen::Ref<const MatrixXd>& B);

/// A^T A.
MatrixXd columnProducts(const Eigen::Ref<const MatrixXd>& A);

/// The columns that begin at `columns`, each so many times, of out.size() rows.
void sumOfColumns(std::span<const double* const> columns, std::span<const double> times, VectorXd& out);

/// Adds x(k) x(k + lag), summed over k, to sums(lag).
void addLaggedProducts(const Eigen::Ref<const VectorXd>& x, VectorXd& sums);

}  // namespace heft
