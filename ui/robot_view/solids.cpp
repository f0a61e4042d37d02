#include "ui/robot_view/solids.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace heft {
namespace {

constexpr double kHalfTurn = 3.14159265358979323846;

/// Collects points with normals and polygons.
class Builder {
 public:
  Builder() { normals_->SetNumberOfComponents(3); }

  vtkIdType add(const Vector3d& point, const Vector3d& normal) {
    normals_->InsertNextTuple3(normal.x(), normal.y(), normal.z());
    return points_->InsertNextPoint(point.x(), point.y(), point.z());
  }
  void triangle(vtkIdType a, vtkIdType b, vtkIdType c) {
    const vtkIdType ids[3] = {a, b, c};
    cells_->InsertNextCell(3, ids);
  }
  void quad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
    const vtkIdType ids[4] = {a, b, c, d};
    cells_->InsertNextCell(4, ids);
  }
  vtkIdType size() const { return points_->GetNumberOfPoints(); }

  vtkSmartPointer<vtkPolyData> finish() {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetPolys(cells_);
    normals_->SetName("Normals");
    data->GetPointData()->SetNormals(normals_);
    return data;
  }

 private:
  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkFloatArray> normals_ = vtkSmartPointer<vtkFloatArray>::New();
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
};

/// Two unit vectors that make a right-handed set with `z`.
std::pair<Vector3d, Vector3d> crossAxes(const Vector3d& z) {
  const Vector3d x = z.unitOrthogonal();
  return {x, z.cross(x)};
}

/// One ring of a surface of revolution.
struct Ring {
  double z, radius;
  double normalZ, normalOut;
};

/// Revolves rings about the line from `origin` along unit `axis`.
void revolve(Builder& builder, const Vector3d& origin, const Vector3d& axis, const std::vector<Ring>& rings,
             int sides) {
  const auto [x, y] = crossAxes(axis);
  vtkIdType before = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const vtkIdType first = builder.size();
    for (int s = 0; s < sides; ++s) {
      const double angle = 2 * kHalfTurn * s / sides;
      const Vector3d out = std::cos(angle) * x + std::sin(angle) * y;
      builder.add(origin + rings[r].z * axis + rings[r].radius * out,
                  (rings[r].normalZ * axis + rings[r].normalOut * out).normalized());
    }
    // Two rings at one place mark a sharp edge: no faces between them.
    const bool edge = r > 0 && rings[r].z == rings[r - 1].z && rings[r].radius == rings[r - 1].radius;
    if (r > 0 && !edge) {
      for (int s = 0; s < sides; ++s) {
        const int next = (s + 1) % sides;
        builder.quad(before + s, before + next, first + next, first + s);
      }
    }
    before = first;
  }
}

void addHead(Builder& builder, const Vector3d& from, const Vector3d& axis, double length, double radius) {
  const double slope = radius / std::hypot(radius, length), steep = length / std::hypot(radius, length);
  revolve(builder, from, axis,
          {{0, 0, -1, 0}, {0, radius, -1, 0}, {0, radius, slope, steep}, {length, 1e-5, slope, steep}}, 24);
}

/// Rings along a polyline that turn with it without twist.
void addTube(Builder& builder, const std::vector<Vector3d>& way, double radius, int sides) {
  if (way.size() < 2) return;
  Vector3d along = (way[1] - way[0]).normalized();
  Vector3d x = along.unitOrthogonal();
  vtkIdType before = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vector3d& previous = way[i == 0 ? 0 : i - 1];
    const Vector3d& next = way[std::min(i + 1, way.size() - 1)];
    if ((next - previous).norm() > 1e-12) along = (next - previous).normalized();
    x = (x - along * along.dot(x));
    x = x.norm() > 1e-6 ? Vector3d(x.normalized()) : Vector3d(along.unitOrthogonal());
    const Vector3d y = along.cross(x);
    const vtkIdType first = builder.size();
    for (int s = 0; s < sides; ++s) {
      const double angle = 2 * kHalfTurn * s / sides;
      const Vector3d out = std::cos(angle) * x + std::sin(angle) * y;
      builder.add(way[i] + radius * out, out);
    }
    if (i > 0) {
      for (int s = 0; s < sides; ++s) {
        const int after = (s + 1) % sides;
        builder.quad(before + s, before + after, first + after, first + s);
      }
    }
    before = first;
  }
}

/// Both ends of a tube closed by flat discs.
void addCap(Builder& builder, const Vector3d& centre, const Vector3d& outward, double radius) {
  revolve(builder, centre, outward, {{0, radius, 1, 0}, {0, 1e-6, 1, 0}}, 16);
}

}  // namespace

vtkSmartPointer<vtkPolyData> toPolyData(const MeshPart& part) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(static_cast<vtkIdType>(part.vertices.size()));
  for (std::size_t i = 0; i < part.vertices.size(); ++i) {
    points->SetPoint(static_cast<vtkIdType>(i), part.vertices[i].x(), part.vertices[i].y(), part.vertices[i].z());
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& t : part.triangles) {
    const vtkIdType ids[3] = {t[0], t[1], t[2]};
    cells->InsertNextCell(3, ids);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  if (part.normals.size() == part.vertices.size()) {
    auto normals = vtkSmartPointer<vtkFloatArray>::New();
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(static_cast<vtkIdType>(part.normals.size()));
    for (std::size_t i = 0; i < part.normals.size(); ++i) {
      normals->SetTuple3(static_cast<vtkIdType>(i), part.normals[i].x(), part.normals[i].y(), part.normals[i].z());
    }
    data->GetPointData()->SetNormals(normals);
  }
  return data;
}

vtkSmartPointer<vtkPolyData> toLines(const std::vector<std::vector<Vector3d>>& edges) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& edge : edges) {
    lines->InsertNextCell(static_cast<vtkIdType>(edge.size()));
    for (const Vector3d& p : edge) lines->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), p.z()));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

vtkSmartPointer<vtkPolyData> makeArrow(const Vector3d& from, const Vector3d& to, double radius) {
  return makeBentArrow({from, to}, radius);
}

vtkSmartPointer<vtkPolyData> makeBentArrow(const std::vector<Vector3d>& way, double radius) {
  Builder builder;
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  if (way.size() < 2 || length < 1e-4) return builder.finish();
  const double head = std::min(6.0 * radius, 0.5 * length);
  // The shaft ends where the head begins, measured along the way.
  std::vector<Vector3d> shaft{way.front()};
  double walked = 0.0;
  Vector3d neck = way.front();
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double step = (way[i] - way[i - 1]).norm();
    if (walked + step >= length - head) {
      const double share = step > 0 ? (length - head - walked) / step : 0.0;
      neck = way[i - 1] + share * (way[i] - way[i - 1]);
      shaft.push_back(neck);
      break;
    }
    shaft.push_back(way[i]);
    walked += step;
  }
  const Vector3d axis = (way.back() - neck).normalized();
  addTube(builder, shaft, radius, 16);
  addCap(builder, shaft.front(), (shaft.front() - shaft[1]).normalized(), radius);
  addHead(builder, neck, axis, head, std::min(2.4 * radius, 0.5 * head));
  return builder.finish();
}

vtkSmartPointer<vtkPolyData> makeTube(const std::vector<Vector3d>& way,
                                      const std::vector<std::array<unsigned char, 3>>& colours, double radius,
                                      int sides) {
  Builder builder;
  addTube(builder, way, radius, sides);
  auto data = builder.finish();
  auto scalars = vtkSmartPointer<vtkUnsignedCharArray>::New();
  scalars->SetName("colours");
  scalars->SetNumberOfComponents(3);
  if (way.size() >= 2 && colours.size() == way.size()) {
    for (const auto& colour : colours) {
      for (int s = 0; s < sides; ++s) scalars->InsertNextTypedTuple(colour.data());
    }
    data->GetPointData()->SetScalars(scalars);
  }
  return data;
}

vtkSmartPointer<vtkPolyData> makeCentreBall(double radius) {
  constexpr int kSteps = 10;  // Facets a quarter turn.
  Builder builder;
  auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetName("colours");
  colours->SetNumberOfComponents(3);
  for (int octant = 0; octant < 8; ++octant) {
    const double sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
    const bool white = sx * sy * sz > 0;
    const std::array<unsigned char, 3> colour =
        white ? std::array<unsigned char, 3>{245, 245, 245} : std::array<unsigned char, 3>{24, 26, 28};
    const vtkIdType first = builder.size();
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        const double a = 0.5 * kHalfTurn * i / kSteps, b = 0.5 * kHalfTurn * j / kSteps;
        const Vector3d n(sx * std::cos(a) * std::cos(b), sy * std::sin(a) * std::cos(b), sz * std::sin(b));
        builder.add(radius * n, n);
      }
    }
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps; ++j) {
        const vtkIdType p = first + i * (kSteps + 1) + j;
        builder.quad(p, p + kSteps + 1, p + kSteps + 2, p + 1);
        colours->InsertNextTypedTuple(colour.data());
      }
    }
  }
  auto data = builder.finish();
  data->GetCellData()->SetScalars(colours);
  return data;
}

vtkSmartPointer<vtkPolyData> makeUnitBall() {
  Builder builder;
  std::vector<Ring> rings;
  constexpr int kRings = 24;
  for (int r = 0; r <= kRings; ++r) {
    const double angle = kHalfTurn * r / kRings - kHalfTurn / 2;
    rings.push_back({std::sin(angle), std::max(1e-6, std::cos(angle)), std::sin(angle), std::cos(angle)});
  }
  revolve(builder, Vector3d::Zero(), Vector3d::UnitZ(), rings, 40);
  return builder.finish();
}

vtkSmartPointer<vtkPolyData> makeUnitCircles() {
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  constexpr int kSides = 64;
  for (int plane = 0; plane < 3; ++plane) {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int s = 0; s < kSides; ++s) {
      const double angle = 2 * kHalfTurn * s / kSides;
      Vector3d p = Vector3d::Zero();
      p((plane + 1) % 3) = 1.004 * std::cos(angle);
      p((plane + 2) % 3) = 1.004 * std::sin(angle);
      points->InsertNextPoint(p.data());
    }
    for (int s = 0; s < kSides; ++s) {
      const vtkIdType ids[2] = {first + s, first + (s + 1) % kSides};
      lines->InsertNextCell(2, ids);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

vtkSmartPointer<vtkPolyData> makeDashedBox(const Vector3d& edges, double dash) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  const Vector3d half = edges / 2.0;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int dashes = std::clamp(static_cast<int>(edges(axis) / (2 * dash)), 2, 60);
    for (int corner = 0; corner < 4; ++corner) {
      for (int d = 0; d < dashes; ++d) {
        // Half a dash at each corner keeps the corners closed.
        const double from = d == 0 ? 0.0 : (d - 0.25) / dashes, to = std::min(1.0, (d + 0.25) / dashes);
        for (const auto& [a, b] : {std::pair(from, to), std::pair(1.0 - 0.25 / dashes, 1.0)}) {
          if (a != from && d != dashes - 1) continue;
          Vector3d p;
          p(u) = corner & 1 ? -half(u) : half(u);
          p(v) = corner & 2 ? -half(v) : half(v);
          p(axis) = -half(axis) + a * edges(axis);
          vtkIdType ids[2];
          ids[0] = points->InsertNextPoint(p.data());
          p(axis) = -half(axis) + b * edges(axis);
          ids[1] = points->InsertNextPoint(p.data());
          lines->InsertNextCell(2, ids);
        }
      }
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

vtkSmartPointer<vtkPolyData> makePuck(double radius, double z0, double z1) {
  Builder builder;
  const double rim = std::min(0.002, 0.3 * (z1 - z0));
  revolve(builder, Vector3d::Zero(), Vector3d::UnitZ(),
          {{z0, 1e-5, -1, 0},
           {z0, radius - rim, -1, 0},
           {z0 + rim, radius, 0, 1},
           {z1 - rim, radius, 0, 1},
           {z1, radius - rim, 1, 0},
           {z1, 1e-5, 1, 0}},
          48);
  return builder.finish();
}

vtkSmartPointer<vtkPolyData> makeBox(const Vector3d& edges) {
  Builder builder;
  const Vector3d half = edges / 2.0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vector3d n = Vector3d::Zero();
      n(axis) = side;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      vtkIdType ids[4];
      const double corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
      for (int c = 0; c < 4; ++c) {
        Vector3d p;
        p(axis) = side * half(axis);
        p(u) = corners[c][0] * half(u) * side;
        p(v) = corners[c][1] * half(v);
        ids[c] = builder.add(p, n);
      }
      builder.quad(ids[0], ids[1], ids[2], ids[3]);
    }
  }
  return builder.finish();
}

}  // namespace heft
