#include "core/math/linear_algebra.h"

namespace heft {

SymmetricEigen symmetricEigen(const MatrixArgument& M) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(M);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

SymmetricEigen generalizedEigen(const MatrixArgument& A, const MatrixArgument& B) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(A, B);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

}  // namespace heft
