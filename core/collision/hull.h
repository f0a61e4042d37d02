#pragma once
// Convex hulls of points.
#include <array>
#include <vector>

#include "core/base/result.h"
#include "core/math/rigid.h"

namespace heft {

struct ConvexHull {
  Eigen::Matrix3Xd vertices;                  ///< [m]
  std::vector<std::array<int, 3>> triangles;  ///< Of vertices, counter-clockwise seen from outside
  Eigen::Matrix4Xd faces;                     ///< [n; d]: inside where n . x + d <= 0 for all, |n| = 1
  bool contains(const Vector3d& point) const;
};

/// One column a point.
Eigen::Matrix3Xd columnsOf(const std::vector<Vector3d>& points);
/// Of a box about the origin with edges `size`.
Eigen::Matrix3Xd boxCorners(const Vector3d& size);

/// Of `points`, 3 x N [m], by Qhull (Barber, Dobkin, Huhdanpaa 1996, doi 10.1145/235815.235821). Points that lie in a
/// plane, on a line or in one place get a thickness of half a millimetre first. Fails without points.
Result<ConvexHull> convexHull(const Eigen::Matrix3Xd& points);

}  // namespace heft
