#include "core/collision/link_bodies.h"

#include <cmath>
#include <numbers>

#include "core/collision/hull.h"
#include "core/mesh/mesh.h"

namespace heft {

namespace {

/// Points on and around a round body of this radius whose hull holds it: corners stand out by 1 / cos(pi / n).
void addRing(double radius, double z, std::vector<Vector3d>& points) {
  constexpr int kCorners = 24;
  const double outside = radius / std::cos(std::numbers::pi / kCorners);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    points.emplace_back(outside * std::cos(angle), outside * std::sin(angle), z);
  }
}

Result<std::vector<Vector3d>> pointsOf(const Visual& body) {
  std::vector<Vector3d> points;
  switch (body.kind) {
    case Visual::Kind::box: {
      const Eigen::Matrix3Xd corners = boxCorners(body.size);
      for (Eigen::Index i = 0; i < corners.cols(); ++i) points.emplace_back(corners.col(i));
      break;
    }
    case Visual::Kind::cylinder:
      for (const double z : {-0.5, 0.5}) addRing(body.size.x(), z * body.size.y(), points);
      break;
    case Visual::Kind::sphere: {
      constexpr int kRings = 12;
      const double outside = body.size.x() / std::cos(0.5 * std::numbers::pi / kRings);
      for (int i = 1; i < kRings; ++i) {
        const double latitude = std::numbers::pi * (static_cast<double>(i) / kRings - 0.5);
        addRing(outside * std::cos(latitude), outside * std::sin(latitude), points);
      }
      for (const double z : {-outside, outside}) points.emplace_back(0.0, 0.0, z);
      break;
    }
    case Visual::Kind::mesh: {
      const auto mesh = loadMesh(body.file);
      if (!mesh) return mesh.error();
      for (const auto& part : mesh->parts)
        for (const auto& vertex : part.vertices)
          if (vertex.allFinite()) points.emplace_back(body.size.cwiseProduct(vertex.cast<double>()));
      break;
    }
  }
  for (auto& point : points) point = body.X_LV * point;
  return points;
}

/// `link` hangs on `from` by fixed joints alone.
bool isFixedBeyond(const RobotModel& robot, int link, int from) {
  while (link != from) {
    const int joint = robot.links()[static_cast<std::size_t>(link)].parentJoint;
    if (joint < 0 || robot.joints()[static_cast<std::size_t>(joint)].type != JointType::fixed) return false;
    link = robot.joints()[static_cast<std::size_t>(joint)].parentLink;
  }
  return true;
}

}  // namespace

Result<std::vector<LinkBody>> linkBodies(const RobotModel& robot, const std::optional<int>& toolFrom) {
  std::vector<LinkBody> out;
  for (int i = 0; i < static_cast<int>(robot.links().size()); ++i) {
    const Link& link = robot.links()[static_cast<std::size_t>(i)];
    if (toolFrom && i != *toolFrom && isFixedBeyond(robot, i, *toolFrom)) continue;
    std::vector<Vector3d> looks;
    for (const Visual& body : link.collisions.empty() ? link.visuals : link.collisions) {
      const auto points = pointsOf(body);
      if (!points) return points.error();
      if (!link.collisions.empty() && !points->empty()) out.push_back({link.name, i, columnsOf(*points)});
      if (link.collisions.empty()) looks.insert(looks.end(), points->begin(), points->end());
    }
    if (!looks.empty()) out.push_back({link.name, i, columnsOf(looks)});
  }
  return out;
}

}  // namespace heft
