#pragma once
// Few weighted points that stand for a body: chosen from many so that the moments stay right.
#include "core/math/rigid.h"

namespace heft {

struct WeightedPoints {
  Eigen::Matrix3Xd points;  ///< [m]
  VectorXd weights;         ///< Positive; sum to 1 unless stated otherwise.
};

/// Term `index` of the three-dimensional R sequence (Roberts 2018, generalised golden ratio) in [0,1)^3: deterministic
/// points that fill the cube more evenly than random ones.
Vector3d evenPoint(long index);

/// At most `count` of the fine points, one for each cell of a k-d tree with equal weights. Within each cell the point
/// is taken that keeps the running first and second moments closest to those of the fine set. Weights are normalised
/// to 1.
WeightedPoints thinned(const WeightedPoints& fine, int count);

/// Moves the points by the lower triangular affine map after which their pseudo-inertia sum w [x;1][x;1]^T is
/// exactly `unit` (which has unit(3,3) = 1 and must be positive definite). False if the points lie in a plane.
bool matchMoments(WeightedPoints& samples, const Matrix4d& unit);

/// sum w [x;1][x;1]^T
Matrix4d pseudoInertiaOf(const WeightedPoints& samples);

}  // namespace heft
