#include "ui/robot_view/tool_solid.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/payload/shape_moments.h"

namespace heft {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr int kSides = 64, kArcs = 12;
constexpr double kSharp = 0.86;                 ///< Cosine of 30 degrees: edges of a mesh that are drawn
constexpr std::size_t kMostTriangles = 400000;  ///< Beyond that a mesh is drawn without edges.

struct Outline {
  double z, r;
};

void triangle(MeshPart& part, const Vector3d (&p)[3], const Vector3d (&n)[3]) {
  const auto first = static_cast<unsigned>(part.vertices.size());
  for (int i = 0; i < 3; ++i) {
    part.vertices.push_back(p[i].cast<float>());
    part.normals.push_back(n[i].normalized().cast<float>());
  }
  part.triangles.push_back({first, first + 1, first + 2});
}

void quad(MeshPart& part, const Vector3d (&p)[4], const Vector3d (&n)[4]) {
  triangle(part, {p[0], p[1], p[2]}, {n[0], n[1], n[2]});
  triangle(part, {p[0], p[2], p[3]}, {n[0], n[2], n[3]});
}

Vector3d around(double angle, double radius, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// Faces that one segment of the outline sweeps; the outline goes so that the outside is at its right, seen with z up.
void sweep(MeshPart& part, Outline a, Outline b, double normalA, double normalB) {
  // normalA, normalB: angle of the normal above the xy plane at both ends.
  for (int s = 0; s < kSides; ++s) {
    const double from = kTurn * s / kSides, to = kTurn * (s + 1) / kSides;
    const auto normal = [&](double angle, double tilt) {
      return Vector3d(around(angle, std::cos(tilt), std::sin(tilt)));
    };
    quad(part, {around(from, a.r, a.z), around(to, a.r, a.z), around(to, b.r, b.z), around(from, b.r, b.z)},
         {normal(from, normalA), normal(to, normalA), normal(to, normalB), normal(from, normalB)});
  }
}

std::vector<Vector3d> ring(double radius, double z) {
  std::vector<Vector3d> line;
  for (int s = 0; s <= kSides; ++s) line.push_back(around(kTurn * s / kSides, radius, z));
  return line;
}

void addCuboid(ToolSolid& solid, const Vector3d& edges) {
  const Vector3d h = edges / 2;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const double side : {-1.0, 1.0}) {
      Vector3d corner[4];
      const double signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
      for (int c = 0; c < 4; ++c) {
        corner[c](axis) = side * h(axis);
        corner[c](u) = signs[c][0] * h(u) * side;
        corner[c](v) = signs[c][1] * h(v);
      }
      const Vector3d n = side * Vector3d::Unit(axis);
      quad(solid.faces, {corner[0], corner[1], corner[2], corner[3]}, {n, n, n, n});
    }
    for (const double su : {-1.0, 1.0}) {
      for (const double sv : {-1.0, 1.0}) {
        Vector3d from;
        from(axis) = -h(axis), from(u) = su * h(u), from(v) = sv * h(v);
        Vector3d to = from;
        to(axis) = h(axis);
        solid.edges.push_back({from, to});
      }
    }
  }
}

/// A ball's half with its pole at z = centre + sign * radius.
void addDome(ToolSolid& solid, double radius, double centre, double sign) {
  for (int i = 0; i < kArcs; ++i) {
    const double a = sign > 0 ? kTurn / 4 * i / kArcs : kTurn / 4 * (i - kArcs) / kArcs;
    const double b = a + kTurn / 4 / kArcs;
    sweep(solid.faces, {centre + radius * std::sin(a), radius * std::cos(a)},
          {centre + radius * std::sin(b), radius * std::cos(b)}, a, b);
  }
}

void addMeridians(ToolSolid& solid, double radius, double low, double high) {
  for (int k = 0; k < 2; ++k) {
    std::vector<Vector3d> line;
    for (int s = 0; s <= 2 * kSides; ++s) {
      const double angle = kTurn * s / (2 * kSides);
      const double out = radius * std::cos(angle), z = radius * std::sin(angle);
      line.emplace_back(k == 0 ? out : 0.0, k == 1 ? out : 0.0, z + (z >= 0 ? high : low));
    }
    line.push_back(line.front());
    solid.edges.push_back(line);
  }
}

void addRound(ToolSolid& solid, double radius, double inner, double low, double high) {
  sweep(solid.faces, {low, radius}, {high, radius}, 0, 0);
  sweep(solid.faces, {low, inner}, {low, radius}, -kTurn / 4, -kTurn / 4);
  sweep(solid.faces, {high, radius}, {high, inner}, kTurn / 4, kTurn / 4);
  solid.edges.push_back(ring(radius, low));
  solid.edges.push_back(ring(radius, high));
  if (inner <= 0) return;
  sweep(solid.faces, {high, inner}, {low, inner}, kTurn / 2, kTurn / 2);
  solid.edges.push_back(ring(inner, low));
  solid.edges.push_back(ring(inner, high));
}

/// Edges of a mesh where its faces meet sharply or end.
void addSharpEdges(ToolSolid& solid) {
  const MeshPart& part = solid.faces;
  if (part.triangles.size() > kMostTriangles) return;
  using Key = std::array<float, 3>;
  std::map<Key, int> corner;
  std::vector<int> of(part.vertices.size());
  std::vector<Vector3d> place;
  for (std::size_t v = 0; v < part.vertices.size(); ++v) {
    const auto& p = part.vertices[v];
    const auto [found, fresh] = corner.try_emplace(Key{p.x(), p.y(), p.z()}, static_cast<int>(place.size()));
    if (fresh) place.push_back(p.cast<double>());
    of[v] = found->second;
  }
  struct Side {
    Vector3d normal;
    bool paired = false, sharp = false;
  };
  std::map<std::pair<int, int>, Side> sides;
  for (const auto& t : part.triangles) {
    const int c[3] = {of[t[0]], of[t[1]], of[t[2]]};
    const Vector3d n = (place[c[1]] - place[c[0]]).cross(place[c[2]] - place[c[0]]);
    if (n.norm() <= 0) continue;
    for (int i = 0; i < 3; ++i) {
      const auto key = std::minmax(c[i], c[(i + 1) % 3]);
      const auto [side, fresh] = sides.try_emplace({key.first, key.second}, Side{n.normalized()});
      if (fresh) continue;
      side->second.paired = true;
      side->second.sharp = side->second.sharp || side->second.normal.dot(n.normalized()) < kSharp;
    }
  }
  for (const auto& [ends, side] : sides)
    if (!side.paired || side.sharp) solid.edges.push_back({place[ends.first], place[ends.second]});
}

void addMesh(ToolSolid& solid, const ShapeBody& body) {
  if (!body.mesh) return;
  for (const MeshPart& part : body.mesh->parts) {
    const auto first = static_cast<unsigned>(solid.faces.vertices.size());
    for (const auto& v : part.vertices) solid.faces.vertices.push_back(static_cast<float>(body.unit) * v);
    solid.faces.normals.insert(solid.faces.normals.end(), part.normals.begin(), part.normals.end());
    for (const auto& t : part.triangles) {
      if (std::max({t[0], t[1], t[2]}) < part.vertices.size())
        solid.faces.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  addSharpEdges(solid);
}

bool drawable(const ShapeBody& body) {
  return body.dims.size() == dimensionNames(body.kind).size() &&
         std::all_of(body.dims.begin(), body.dims.end(), [](double d) { return std::isfinite(d) && d >= 0; });
}

}  // namespace

ToolSolid makeToolSolid(const ShapeBody& body) {
  ToolSolid solid;
  if (!drawable(body)) return solid;
  const auto& d = body.dims;
  switch (body.kind) {
    case BodyKind::box:
    case BodyKind::plate:
      addCuboid(solid, {d[0], d[1], d[2]});
      break;
    case BodyKind::cylinder:
      addRound(solid, d[0], 0, -d[1] / 2, d[1] / 2);
      break;
    case BodyKind::tube:
      addRound(solid, d[0], std::min(d[0], d[1]), -d[2] / 2, d[2] / 2);
      break;
    case BodyKind::sphere:
      addDome(solid, d[0], 0, 1);
      addDome(solid, d[0], 0, -1);
      solid.edges.push_back(ring(d[0], 0));
      addMeridians(solid, d[0], 0, 0);
      break;
    case BodyKind::cone: {
      const double tilt = std::atan2(d[0], d[1]);
      sweep(solid.faces, {0, d[0]}, {d[1], 0}, tilt, tilt);
      sweep(solid.faces, {0, 0}, {0, d[0]}, -kTurn / 4, -kTurn / 4);
      solid.edges.push_back(ring(d[0], 0));
      break;
    }
    case BodyKind::capsule:
      sweep(solid.faces, {-d[1] / 2, d[0]}, {d[1] / 2, d[0]}, 0, 0);
      addDome(solid, d[0], d[1] / 2, 1);
      addDome(solid, d[0], -d[1] / 2, -1);
      solid.edges.push_back(ring(d[0], d[1] / 2));
      solid.edges.push_back(ring(d[0], -d[1] / 2));
      addMeridians(solid, d[0], -d[1] / 2, d[1] / 2);
      break;
    case BodyKind::mesh:
      addMesh(solid, body);
      break;
  }
  if (body.wall && body.kind != BodyKind::mesh && body.kind != BodyKind::tube && *body.wall > 0 &&
      *body.wall < inradius(body)) {
    const ShapeBody cavity = cavityOf(body);
    solid.hollow = makeToolSolid(cavity).edges;
    for (auto& line : solid.hollow)
      for (Vector3d& p : line) p = cavity.X_SB * p;
  }
  return solid;
}

}  // namespace heft
