#include "core/math/linear_algebra.h"

namespace heft {

ThinSvd thinSvd(const MatrixArgument& A) {
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

VectorXd singularValues(const MatrixArgument& A) {
  return Eigen::JacobiSVD<MatrixXd>(A, Eigen::ComputeThinU | Eigen::ComputeThinV).singularValues();
}

MatrixXd rightSingularVectors(const MatrixArgument& A, SvdKind kind) {
  // Householder reflections without pivoting are all that tall matrices need; thin U and V ask for no more.
  constexpr unsigned kThin = Eigen::ComputeThinU | Eigen::ComputeThinV;
  if (kind == SvdKind::divideAndConquer) return Eigen::BDCSVD<MatrixXd>(A, kThin).matrixV();
  return Eigen::JacobiSVD<MatrixXd, Eigen::HouseholderQRPreconditioner>(A, kThin).matrixV();
}

}  // namespace heft
