#include "core/math/linear_algebra.h"

namespace heft {

MatrixXd product(const MatrixArgument& A, const MatrixArgument& B) { return A * B; }

MatrixXd transposedProduct(const MatrixArgument& A, const MatrixArgument& B) { return A.transpose() * B; }

MatrixXd congruence(const MatrixArgument& J, const MatrixArgument& C) { return product(product(J, C), J.transpose()); }

LeastSquares leastSquares(const MatrixArgument& A, const VectorArgument& y) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(A);
  return {qr.solve(y), qr.rank() == A.cols()};
}

VectorXd shortestLeastSquares(const MatrixArgument& A, const VectorArgument& y) {
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(A).solve(y);
}

MatrixXd pseudoInverse(const MatrixArgument& A) {
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(A).pseudoInverse();
}

MatrixXd upperTriangle(const MatrixArgument& A) {
  return Eigen::HouseholderQR<MatrixXd>(A).matrixQR().topRows(A.cols()).triangularView<Eigen::Upper>();
}

VectorXd solveUpper(const MatrixArgument& U, const VectorArgument& b) {
  return U.triangularView<Eigen::Upper>().solve(b);
}

SymmetricSolver::SymmetricSolver(const MatrixArgument& H) : ldlt_(H) {}

VectorXd SymmetricSolver::solve(const VectorArgument& g) const { return ldlt_.solve(g); }

MatrixXd SymmetricSolver::solveAll(const MatrixArgument& G) const { return ldlt_.solve(G); }

VectorXd solveSymmetric(const MatrixArgument& H, const VectorArgument& g) { return SymmetricSolver(H).solve(g); }

MatrixXd inverse(const MatrixArgument& A) { return Eigen::PartialPivLU<MatrixXd>(A).inverse(); }

MatrixXd choleskyFactor(const MatrixArgument& M) { return Eigen::LLT<MatrixXd>(M).matrixL(); }

MatrixXd whitenerOf(const MatrixArgument& M) {
  return Eigen::LLT<MatrixXd>(M).matrixL().solve(MatrixXd::Identity(M.rows(), M.cols()));
}

SymmetricEigen symmetricEigen(const MatrixArgument& M) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(M);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

SymmetricEigen generalizedEigen(const MatrixArgument& A, const MatrixArgument& B) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(A, B);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

VectorXd singularValues(const MatrixArgument& A) {
  return Eigen::JacobiSVD<MatrixXd, Eigen::HouseholderQRPreconditioner>(A).singularValues();
}

MatrixXd rightSingularVectors(const MatrixArgument& A, SvdKind kind) {
  // Householder reflections without pivoting are all that tall matrices need; thin U and V ask for no more.
  constexpr unsigned kThin = Eigen::ComputeThinU | Eigen::ComputeThinV;
  if (kind == SvdKind::divideAndConquer) return Eigen::BDCSVD<MatrixXd>(A, kThin).matrixV();
  return Eigen::JacobiSVD<MatrixXd, Eigen::HouseholderQRPreconditioner>(A, kThin).matrixV();
}

}  // namespace heft
