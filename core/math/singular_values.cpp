#include "core/math/linear_algebra.h"

namespace heft {

namespace {

/// Householder reflections without pivoting are all that thin factors need.
using HouseholderSvd = Eigen::JacobiSVD<MatrixXd, Eigen::HouseholderQRPreconditioner>;

}  // namespace

ThinSvd thinSvd(const MatrixArgument& A) {
  const HouseholderSvd svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

VectorXd singularValues(const MatrixArgument& A) {
  return HouseholderSvd(A, Eigen::ComputeThinU | Eigen::ComputeThinV).singularValues();
}

}  // namespace heft
