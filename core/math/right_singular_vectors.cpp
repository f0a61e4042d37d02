#include "core/math/linear_algebra.h"

namespace heft {

MatrixXd rightSingularVectors(const MatrixArgument& A, SvdKind kind) {
  if (kind == SvdKind::jacobi) return thinSvd(A).V;
  return Eigen::BDCSVD<MatrixXd>(A, Eigen::ComputeThinU | Eigen::ComputeThinV).matrixV();
}

}  // namespace heft
