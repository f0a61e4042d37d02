#include "core/estimation/inside_shape.h"

#include <algorithm>
#include <cmath>

#include "core/math/linear_algebra.h"
#include "core/math/nnls.h"

namespace heft {

ShapeCone::ShapeCone(const Eigen::Matrix3Xd& points) : basis_(10, points.cols()) {
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector4d x = points.col(i).homogeneous();
    basis_.col(i) = parametersFromPseudoInertia(x * x.transpose());
  }
}

Vector10d ShapeCone::nearest(const Matrix10d& root, const Vector10d& target) const {
  return basis_ * nonNegativeLeastSquares(root * basis_, root * target);
}

Vector10d ShapeCone::evenly(double mass) const { return mass * basis_.rowwise().mean(); }

InsideSolution solveInside(const Triangle& R, const MapPrior& prior, bool bias, const MapSolution& free,
                           const ShapeCone& cone) {
  const MapCost cost(R, prior, bias);
  // A body with extent inside the shape keeps every step away from bodies without.
  Vector10d phi = cone.evenly(free.phi(0));
  Vector10d v = vFromParameters(prior, phi);
  double best = cost(v);
  InsideSolution out;
  int iterations = 0;
  bool converged = false;
  for (; iterations < 100 && !converged; ++iterations) {
    const Matrix10d J = parametersJacobian(prior, v);
    const MatrixXd AJ = product(cost.A(), J);
    const Matrix10d H = transposedProduct(AJ, AJ) + prior.curvature(v);
    const Vector10d gradient = AJ.transpose() * (cost.A() * phi - cost.y()) + prior.halfGradient(v);
    out.root = transposedProduct(choleskyFactor(H), inverse(J));
    const Vector10d target = phi - J * solveSymmetric(H, gradient);
    const Vector10d step = cone.nearest(out.root, target) - phi;
    converged = true;
    for (double length = 0.999; length > 1e-6; length *= 0.5) {
      const Vector10d next = phi + length * step;
      const Vector10d at = vFromParameters(prior, next);
      const double value = cost(at);
      if (!(value < best)) continue;
      converged = best - value < 1e-7;
      best = value;
      phi = next;
      v = at;
      break;
    }
  }
  out.map = solutionAt(R, prior, bias, v);
  out.map.iterations = free.iterations + iterations;
  out.map.converged = free.converged && converged;
  out.moved = (out.root * (phi - free.phi)).norm();
  return out;
}

}  // namespace heft
