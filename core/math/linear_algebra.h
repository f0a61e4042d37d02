#pragma once
// Products and decompositions of matrices whose size is known at run time, compiled once: each of Eigen's
// decompositions takes a second and more in every unit that instantiates it. Matrices of fixed size bind without a
// copy.
#include "core/math/rigid.h"

namespace heft {

using MatrixArgument = Eigen::Ref<const MatrixXd>;
using VectorArgument = Eigen::Ref<const VectorXd>;

/// A B.
MatrixXd product(const MatrixArgument& A, const MatrixArgument& B);
/// A^T B.
MatrixXd transposedProduct(const MatrixArgument& A, const MatrixArgument& B);
/// J C J^T: how a covariance C passes through a linear map.
MatrixXd congruence(const MatrixArgument& J, const MatrixArgument& C);

/// A x = y in least squares, by Householder QR with column pivoting.
struct LeastSquares {
  VectorXd x;
  bool fullRank = false;
};
LeastSquares leastSquares(const MatrixArgument& A, const VectorArgument& y);
/// The shortest of all least-squares solutions, by a complete orthogonal decomposition. Pivots below `threshold` times
/// the largest count as zero; 0: those that are rounding.
VectorXd shortestLeastSquares(const MatrixArgument& A, const VectorArgument& y, double threshold = 0.0);
MatrixXd pseudoInverse(const MatrixArgument& A);
/// The triangle R of A = Q R: as many rows as A has columns.
MatrixXd upperTriangle(const MatrixArgument& A);
/// Orthonormal columns that span those of A, by Householder QR: all of them, or as many as A has rank.
MatrixXd orthonormal(const MatrixArgument& A);
MatrixXd columnSpace(const MatrixArgument& A);
/// U x = b with the upper triangle of U.
VectorXd solveUpper(const MatrixArgument& U, const VectorArgument& b);

/// Solves with symmetric matrices that are not negative, by LDL^T: H x = g, and H X = G for several right sides.
class SymmetricSolver {
 public:
  SymmetricSolver() = default;
  explicit SymmetricSolver(const MatrixArgument& H);
  VectorXd solve(const VectorArgument& g) const;
  MatrixXd solveAll(const MatrixArgument& G) const;

 private:
  Eigen::LDLT<MatrixXd> ldlt_;
};
VectorXd solveSymmetric(const MatrixArgument& H, const VectorArgument& g);
/// A^-1 by LU with partial pivoting.
MatrixXd inverse(const MatrixArgument& A);

/// Lower triangle L with M = L L^T. M must be positive definite.
MatrixXd choleskyFactor(const MatrixArgument& M);
/// L^-1: what makes values with covariance M white.
MatrixXd whitenerOf(const MatrixArgument& M);

/// Eigenvalues, rising, and their vectors as columns.
struct SymmetricEigen {
  VectorXd values;
  MatrixXd vectors;
};
SymmetricEigen symmetricEigen(const MatrixArgument& M);
/// A x = lambda B x with B positive definite.
SymmetricEigen generalizedEigen(const MatrixArgument& A, const MatrixArgument& B);

/// A = U diag(values) V^T, thin; values falling.
struct ThinSvd {
  MatrixXd U;
  VectorXd values;
  MatrixXd V;
};
ThinSvd thinSvd(const MatrixArgument& A);
/// Falling.
VectorXd singularValues(const MatrixArgument& A);

}  // namespace heft
