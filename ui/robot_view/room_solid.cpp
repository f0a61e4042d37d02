#include "ui/robot_view/room_solid.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/collision/hull.h"

namespace heft {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// Edges at which the surface turns by more than eight degrees, or ends.
std::vector<std::vector<Vector3d>> sharpEdges(const Eigen::Matrix3Xd& vertices, const Triangles& triangles) {
  const double kFlat = std::cos(0.14);
  std::map<std::pair<int, int>, std::vector<Vector3d>> normals;
  for (const auto& t : triangles) {
    const Vector3d a = vertices.col(t[0]), b = vertices.col(t[1]), c = vertices.col(t[2]);
    const Vector3d normal = (b - a).cross(c - a).stableNormalized();
    for (std::size_t i = 0; i < 3; ++i) normals[std::minmax(t[i], t[(i + 1) % 3])].push_back(normal);
  }
  std::vector<std::vector<Vector3d>> edges;
  for (const auto& [ends, sides] : normals)
    if (sides.size() != 2 || sides[0].dot(sides[1]) < kFlat)
      edges.push_back({Vector3d(vertices.col(ends.first)), Vector3d(vertices.col(ends.second))});
  return edges;
}

ToolSolid solidOf(const Eigen::Matrix3Xd& vertices, const Triangles& triangles) {
  ToolSolid out;
  for (const auto& t : triangles) {
    const Vector3d a = vertices.col(t[0]), b = vertices.col(t[1]), c = vertices.col(t[2]);
    const Vector3d normal = (b - a).cross(c - a).stableNormalized();
    const auto first = static_cast<unsigned>(out.faces.vertices.size());
    for (const Vector3d& p : {a, b, c}) {
      out.faces.vertices.push_back(p.cast<float>());
      out.faces.normals.push_back(normal.cast<float>());
    }
    out.faces.triangles.push_back({first, first + 1, first + 2});
  }
  out.edges = sharpEdges(vertices, triangles);
  return out;
}

ToolSolid solidOf(const RoomPlane& plane) {
  constexpr double kHalf = 0.8;  // [m] of its edges; an arm reaches as far
  const Vector3d foot = plane.normal.dot(plane.point) * plane.normal;
  const Vector3d other = std::abs(plane.normal.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
  const Vector3d along = (other - other.dot(plane.normal) * plane.normal).normalized();
  const Vector3d across = plane.normal.cross(along);
  Eigen::Matrix3Xd corners(3, 4);
  corners << foot - kHalf * along - kHalf * across, foot + kHalf * along - kHalf * across,
      foot + kHalf * along + kHalf * across, foot - kHalf * along + kHalf * across;
  return solidOf(corners, {{0, 1, 2}, {0, 2, 3}});
}

ToolSolid solidOf(const RoomBox& box) {
  const auto hull = convexHull(box.X_BO * boxCorners(box.size));
  return hull ? solidOf(hull->vertices, hull->triangles) : ToolSolid();
}

ToolSolid solidOf(const RoomMesh& mesh) {
  std::vector<Vector3d> points;
  Triangles triangles;
  for (const MeshPart& part : mesh.mesh->parts) {
    const auto first = static_cast<unsigned>(points.size());
    for (const auto& v : part.vertices) points.emplace_back(mesh.X_BO * (mesh.unit * v.cast<double>()));
    for (const auto& t : part.triangles)
      triangles.push_back(
          {static_cast<int>(first + t[0]), static_cast<int>(first + t[1]), static_cast<int>(first + t[2])});
  }
  return solidOf(columnsOf(points), triangles);
}

}  // namespace

std::vector<ToolSolid> roomSolids(const Room& room) {
  std::vector<ToolSolid> out;
  for (const Obstacle& obstacle : room.obstacles)
    out.push_back(std::visit([](const auto& body) { return solidOf(body); }, obstacle.body));
  return out;
}

std::vector<HullEdges> hullEdges(const std::vector<HullSurface>& hulls) {
  std::vector<HullEdges> out;
  for (const HullSurface& hull : hulls) out.push_back({hull.link, sharpEdges(hull.vertices, hull.triangles)});
  return out;
}

}  // namespace heft
