#include "core/collision/fcl_bodies.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/distance.h>

#include <memory>

namespace heft {

struct FclBody {
  fcl::BVHModel<fcl::OBBRSSd> surface;
  std::unique_ptr<const fcl::Convexd> convex;
};

namespace {

void addSurface(const Eigen::Matrix3Xd& vertices, const std::vector<std::array<int, 3>>& triangles, FclBody& body) {
  body.surface.beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.cols()));
  std::vector<Vector3d> points;
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) points.emplace_back(vertices.col(i));
  std::vector<fcl::Triangle> corners;
  for (const auto& t : triangles)
    corners.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                         static_cast<std::size_t>(t[2]));
  body.surface.addSubModel(points, corners);
  body.surface.endModel();
}

void addConvex(const Eigen::Matrix3Xd& vertices, const std::vector<std::array<int, 3>>& triangles, FclBody& body) {
  auto points = std::make_shared<std::vector<Vector3d>>();
  auto faces = std::make_shared<std::vector<int>>();
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) points->emplace_back(vertices.col(i));
  for (const auto& t : triangles) faces->insert(faces->end(), {3, t[0], t[1], t[2]});
  body.convex = std::make_unique<const fcl::Convexd>(points, static_cast<int>(triangles.size()), faces);
}

}  // namespace

}  // namespace heft

heft::FclBody* heft_make_fcl_body(const Eigen::Matrix3Xd& vertices, const std::vector<std::array<int, 3>>& triangles,
                                  bool convex) {
  auto body = std::make_unique<heft::FclBody>();
  heft::addSurface(vertices, triangles, *body);
  if (convex) heft::addConvex(vertices, triangles, *body);
  return body.release();
}

void heft_delete_fcl_body(heft::FclBody* body) { delete body; }

double heft_between_convex(const heft::FclBody& a, const heft::Isometry3d& X_Wa, const heft::FclBody& b,
                           const heft::Isometry3d& X_Wb, heft::NearestPoints& nearest) {
  fcl::DistanceResultd result;
  const double between = fcl::distance(a.convex.get(), X_Wa, b.convex.get(), X_Wb, fcl::DistanceRequestd(true), result);
  nearest = {result.nearest_points[0], result.nearest_points[1]};
  return between;
}

double heft_between_surfaces(const heft::FclBody& a, const heft::Isometry3d& X_Wa, const heft::FclBody& b,
                             const heft::Isometry3d& X_Wb, heft::NearestPoints* nearest) {
  fcl::DistanceResultd result;
  const fcl::DistanceRequestd request(nearest != nullptr);
  const double between = fcl::distance(&a.surface, X_Wa, &b.surface, X_Wb, request, result);
  if (nearest) *nearest = {result.nearest_points[0], result.nearest_points[1]};
  return between;
}
