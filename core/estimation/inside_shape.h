#pragma once
// The map estimate with all mass held inside the picked shape.
#include "core/estimation/map.h"

namespace heft {

/// All payloads P = sum mu_k [x_k; 1][x_k; 1]^T, mu >= 0, over points x_k of a shape: a convex cone.
class ShapeCone {
 public:
  explicit ShapeCone(const Eigen::Matrix3Xd& points);  ///< [m], S axes
  /// The payload of the cone that minimises |root (phi - target)|^2.
  Vector10d nearest(const Matrix10d& root, const Vector10d& target) const;
  /// All points with equal mass, `mass` [kg] together.
  Vector10d evenly(double mass) const;

 private:
  Eigen::Matrix<double, 10, Eigen::Dynamic> basis_;  ///< Parameters of 1 kg at each point
};

struct InsideSolution {
  MapSolution map;   ///< The most probable payload inside the cone; its covariance is that without the bound.
  Matrix10d root;    ///< Of the posterior's information about phi there: the metric for draws
  double moved = 0;  ///< How far the bound moved the estimate, in the posterior's standard deviations
};

/// Gauss-Newton steps projected on the cone. `free` is the solution without the bound.
InsideSolution solveInside(const Triangle& R, const MapPrior& prior, bool bias, const MapSolution& free,
                           const ShapeCone& cone);

}  // namespace heft
