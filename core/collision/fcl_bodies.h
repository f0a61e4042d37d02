#pragma once
// Bodies as FCL has them and distances between them, in a shared library of its own that is loaded at its first use:
// FCL and OctoMap took a third of the time in which a program started.
#include <Eigen/Dense>
#include <array>
#include <vector>

#include "core/math/rigid.h"

namespace heft {

/// A surface of triangles, and the convex body that it is around if it is.
struct FclBody;

/// Of two bodies: one point on each.
using NearestPoints = std::array<Vector3d, 2>;

}  // namespace heft

extern "C" {
/// \param convex whether they are the faces of a convex body, normals outwards.
heft::FclBody* heft_make_fcl_body(const Eigen::Matrix3Xd& vertices, const std::vector<std::array<int, 3>>& triangles,
                                  bool convex);
void heft_delete_fcl_body(heft::FclBody* body);
/// Of two convex bodies in poses X_Wa and X_Wb [m]; negative or 0 where they overlap. `nearest` in W.
double heft_between_convex(const heft::FclBody& a, const heft::Isometry3d& X_Wa, const heft::FclBody& b,
                           const heft::Isometry3d& X_Wb, heft::NearestPoints& nearest);
/// Of the surfaces; 0 or less where they cross. `nearest` may be null; where they cross, it says nothing.
double heft_between_surfaces(const heft::FclBody& a, const heft::Isometry3d& X_Wa, const heft::FclBody& b,
                             const heft::Isometry3d& X_Wb, heft::NearestPoints* nearest);
}
