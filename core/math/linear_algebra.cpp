#include "core/math/linear_algebra.h"

namespace heft {

MatrixXd product(const MatrixArgument& A, const MatrixArgument& B) { return A * B; }

MatrixXd transposedProduct(const MatrixArgument& A, const MatrixArgument& B) { return A.transpose() * B; }

MatrixXd congruence(const MatrixArgument& J, const MatrixArgument& C) { return product(product(J, C), J.transpose()); }

LeastSquares leastSquares(const MatrixArgument& A, const VectorArgument& y) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(A);
  return {qr.solve(y), qr.rank() == A.cols()};
}

VectorXd shortestLeastSquares(const MatrixArgument& A, const VectorArgument& y, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition(A.rows(), A.cols());
  if (threshold > 0.0) decomposition.setThreshold(threshold);
  return decomposition.compute(A).solve(y);
}

MatrixXd pseudoInverse(const MatrixArgument& A) {
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(A).pseudoInverse();
}

MatrixXd upperTriangle(const MatrixArgument& A) {
  return Eigen::HouseholderQR<MatrixXd>(A).matrixQR().topRows(A.cols()).triangularView<Eigen::Upper>();
}

MatrixXd orthonormal(const MatrixArgument& A) {
  return Eigen::HouseholderQR<MatrixXd>(A).householderQ() * MatrixXd::Identity(A.rows(), A.cols());
}

MatrixXd columnSpace(const MatrixArgument& A) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(A);
  return qr.householderQ() * MatrixXd::Identity(A.rows(), qr.rank());
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

}  // namespace heft
