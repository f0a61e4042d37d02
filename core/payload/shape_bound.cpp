#include "core/payload/shape_bound.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace heft {

namespace {

/// Directions spread evenly over the sphere (Fibonacci lattice).
std::vector<Vector3d> directions(int count) {
  std::vector<Vector3d> out;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, around = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    out.emplace_back(r * std::cos(around), r * std::sin(around), z);
  }
  return out;
}

void addRim(double radius, double z, std::vector<Vector3d>& points) {
  constexpr int kSteps = 32;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSteps;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

/// Of a mesh: its vertices that stand out furthest in some direction.
void addHull(const ShapeBody& body, std::vector<Vector3d>& points) {
  std::shared_ptr<const Mesh> mesh = body.mesh;
  if (!mesh) {
    auto loaded = loadMesh(body.file);
    if (!loaded) return;  // sampleShape has said why
    mesh = std::make_shared<const Mesh>(std::move(loaded).value());
  }
  for (const Vector3d& direction : directions(200)) {
    const Eigen::Vector3f d = direction.cast<float>();
    const Eigen::Vector3f* furthest = nullptr;
    float best = 0.0f;
    for (const auto& part : mesh->parts)
      for (const auto& vertex : part.vertices)
        if (const float along = vertex.dot(d); vertex.allFinite() && (!furthest || along > best)) {
          furthest = &vertex;
          best = along;
        }
    if (furthest) points.push_back(body.unit * furthest->cast<double>());
  }
}

/// In the body's own frame.
std::vector<Vector3d> outerPoints(const ShapeBody& body) {
  std::vector<Vector3d> points;
  const auto& d = body.dims;
  switch (body.kind) {
    case BodyKind::box:
    case BodyKind::plate:
      for (int i = 0; i < 8; ++i)
        points.push_back(0.5 * Vector3d((i & 1 ? d[0] : -d[0]), (i & 2 ? d[1] : -d[1]), (i & 4 ? d[2] : -d[2])));
      break;
    case BodyKind::cylinder:
      addRim(d[0], -0.5 * d[1], points);
      addRim(d[0], 0.5 * d[1], points);
      break;
    case BodyKind::tube:
      addRim(d[0], -0.5 * d[2], points);
      addRim(d[0], 0.5 * d[2], points);
      break;
    case BodyKind::sphere:
      for (const Vector3d& u : directions(200)) points.push_back(d[0] * u);
      break;
    case BodyKind::cone:
      addRim(d[0], 0.0, points);
      points.emplace_back(0.0, 0.0, d[1]);
      break;
    case BodyKind::capsule:
      for (const Vector3d& u : directions(200))
        points.push_back(d[0] * u + Vector3d(0.0, 0.0, std::copysign(0.5 * d[1], u.z())));
      break;
    case BodyKind::mesh:
      addHull(body, points);
      break;
  }
  return points;
}

}  // namespace

Eigen::Matrix3Xd boundPoints(const Shape& shape, const std::vector<BodySamples>& samples) {
  if (samples.size() != shape.bodies.size())
    throw std::invalid_argument("boundPoints: one set of samples is expected for each body");
  std::vector<Vector3d> all;
  for (std::size_t b = 0; b < samples.size(); ++b) {
    for (Eigen::Index i = 0; i < samples[b].points.cols(); ++i) all.emplace_back(samples[b].points.col(i));
    for (const Vector3d& p : outerPoints(shape.bodies[b])) all.push_back(shape.bodies[b].X_SB * p);
  }
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = all[i];
  return points;
}

}  // namespace heft
