#include "core/payload/tool_sketch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/payload/shape_moments.h"

namespace heft {
namespace {

constexpr std::array<std::pair<ToolPicture, std::string_view>, 10> kNames{{{ToolPicture::box, "box"},
                                                                           {ToolPicture::cylinder, "cylinder"},
                                                                           {ToolPicture::tube, "tube"},
                                                                           {ToolPicture::sphere, "sphere"},
                                                                           {ToolPicture::cone, "cone"},
                                                                           {ToolPicture::capsule, "capsule"},
                                                                           {ToolPicture::plate, "plate"},
                                                                           {ToolPicture::gripper, "gripper"},
                                                                           {ToolPicture::several, "several"},
                                                                           {ToolPicture::mesh, "mesh"}}};

/// Sizes that are taken while nothing is known of the tool (width, depth, height) [m].
Vector3d usualSize(ToolPicture picture) {
  switch (picture) {
    case ToolPicture::plate:
      return {0.120, 0.080, 0.008};
    case ToolPicture::sphere:
      return {0.070, 0.070, 0.070};
    case ToolPicture::capsule:
      return {0.050, 0.050, 0.120};
    case ToolPicture::gripper:
      return {0.074, 0.120, 0.110};
    case ToolPicture::several:
      return {0.060, 0.060, 0.120};
    default:
      return {0.060, 0.060, 0.080};
  }
}

/// Whole millimetres: what a form shows.
double whole(double metres) { return std::max(1e-3, std::round(1e3 * metres) * 1e-3); }

ShapeBody primitive(BodyKind kind, const Vector3d& size, double from) {
  const double across = whole(0.5 * (size.x() + size.y())), high = whole(size.z());
  ShapeBody body;
  body.kind = kind;
  switch (kind) {
    case BodyKind::box:
    case BodyKind::plate:
      body.dims = {whole(size.x()), whole(size.y()), high};
      break;
    case BodyKind::cylinder:
    case BodyKind::cone:
      body.dims = {across / 2, high};
      break;
    case BodyKind::tube:
      body.dims = {across / 2, whole(0.8 * across) / 2, high};
      break;
    case BodyKind::sphere:
      body.dims = {whole((size.x() + size.y() + size.z()) / 3) / 2};
      break;
    case BodyKind::capsule:
      body.dims = {across / 2, std::max(0.0, high - across)};
      break;
    case BodyKind::mesh:
      break;
  }
  body.X_SB.translation().z() = from - extentOf(body).min().z();
  return body;
}

}  // namespace

std::string_view toString(ToolPicture picture) {
  for (const auto& [each, name] : kNames)
    if (each == picture) return name;
  return "box";
}

std::optional<ToolPicture> toolPictureFromString(std::string_view text) {
  for (const auto& [each, name] : kNames)
    if (name == text) return each;
  return std::nullopt;
}

std::optional<BodyKind> bodyKindOf(ToolPicture picture) {
  if (picture == ToolPicture::gripper || picture == ToolPicture::several || picture == ToolPicture::mesh)
    return std::nullopt;
  return bodyKindFromString(toString(picture));
}

ToolPicture pictureOf(const Shape& shape) {
  if (shape.bodies.size() != 1) return ToolPicture::several;
  return toolPictureFromString(toString(shape.bodies.front().kind)).value_or(ToolPicture::box);
}

std::vector<Measure> measuresOf(const ShapeBody& body) {
  const auto& d = body.dims;
  if (d.size() != dimensionNames(body.kind).size()) return {};
  switch (body.kind) {
    case BodyKind::box:
      return {{Length::width, 0, d[0]}, {Length::depth, 1, d[1]}, {Length::height, 2, d[2]}};
    case BodyKind::plate:
      return {{Length::width, 0, d[0]}, {Length::depth, 1, d[1]}, {Length::thickness, 2, d[2]}};
    case BodyKind::cylinder:
    case BodyKind::cone:
      return {{Length::diameter, 0, 2 * d[0]}, {Length::height, 2, d[1]}};
    case BodyKind::tube:
      return {{Length::outerDiameter, 0, 2 * d[0]}, {Length::innerDiameter, -1, 2 * d[1]}, {Length::height, 2, d[2]}};
    case BodyKind::sphere:
      return {{Length::diameter, 0, 2 * d[0]}};
    case BodyKind::capsule:
      return {{Length::diameter, 0, 2 * d[0]}, {Length::wholeLength, 2, d[1] + 2 * d[0]}};
    case BodyKind::mesh:
      break;
  }
  return {};
}

ShapeBody resized(const ShapeBody& body, std::size_t measure, double value, int hold) {
  const std::vector<Measure> measures = measuresOf(body);
  if (measure >= measures.size()) return body;
  ShapeBody out = body;
  auto& d = out.dims;
  switch (body.kind) {
    case BodyKind::box:
    case BodyKind::plate:
      d[measure] = value;
      break;
    case BodyKind::cylinder:
    case BodyKind::cone:
    case BodyKind::tube:
      d[measure] = measures[measure].axis == 2 ? value : value / 2;
      break;
    case BodyKind::sphere:
      d[0] = value / 2;
      break;
    case BodyKind::capsule: {
      // The whole length stays what it was, as long as the two caps fit into it.
      const double across = measure == 0 ? value : 2 * d[0];
      const double along = measure == 1 ? value : d[1] + 2 * d[0];
      d = {across / 2, std::max(0.0, along - across)};
      break;
    }
    case BodyKind::mesh:
      return out;
  }
  // A sphere has no ends; what counts is where it sits along z.
  const int axis = body.kind == BodyKind::sphere ? 2 : measures[measure].axis;
  const auto before = extentOf(body), after = extentOf(out);
  Vector3d shift = Vector3d::Zero();
  for (int a = 0; a < 3; ++a) {
    // Widths of round bodies must not move them along their axis (a capsule that grew longer with its caps).
    const int holdHere = a == axis ? hold : a == 2 ? -1 : 0;
    shift(a) = holdHere < 0   ? before.min()(a) - after.min()(a)
               : holdHere > 0 ? before.max()(a) - after.max()(a)
                              : before.center()(a) - after.center()(a);
  }
  out.X_SB.translation() += out.X_SB.linear() * shift;
  return out;
}

Shape resized(const Shape& shape, ToolPicture picture, std::size_t body, std::size_t measure, double value) {
  Shape out = shape;
  if (body >= out.bodies.size()) return out;
  const auto measures = measuresOf(out.bodies[body]);
  if (measure >= measures.size()) return out;
  const bool along = measures[measure].axis == 2 || out.bodies[body].kind == BodyKind::sphere;
  out.bodies[body] = resized(out.bodies[body], measure, value, along ? -1 : 0);
  if (picture == ToolPicture::gripper && body == 0 && along) {
    const Vector3d grown = (value - measures[measure].value) * out.bodies[0].X_SB.linear().col(2);
    for (std::size_t i = 1; i < out.bodies.size(); ++i) out.bodies[i].X_SB.translation() += grown;
  }
  return out;
}

Eigen::AlignedBox3d extentOf(const ShapeBody& body) {
  Eigen::AlignedBox3d box;
  const auto& d = body.dims;
  if (body.kind == BodyKind::mesh) {
    if (!body.mesh) return box;
    for (const MeshPart& part : body.mesh->parts)
      for (const auto& v : part.vertices)
        if (v.allFinite()) box.extend(Vector3d(body.unit * v.cast<double>()));
    return box;
  }
  if (d.size() != dimensionNames(body.kind).size()) return box;
  Vector3d half = Vector3d::Zero();
  double low = 0.0;
  switch (body.kind) {
    case BodyKind::box:
    case BodyKind::plate:
      half = 0.5 * Vector3d(d[0], d[1], d[2]);
      break;
    case BodyKind::cylinder:
    case BodyKind::cone:
      half = {d[0], d[0], d[1] / 2};
      break;
    case BodyKind::tube:
      half = {d[0], d[0], d[2] / 2};
      break;
    case BodyKind::sphere:
      half.setConstant(d[0]);
      break;
    case BodyKind::capsule:
      half = {d[0], d[0], d[1] / 2 + d[0]};
      break;
    case BodyKind::mesh:
      break;
  }
  low = body.kind == BodyKind::cone ? 0.0 : -half.z();
  box.extend(Vector3d(-half.x(), -half.y(), low));
  box.extend(Vector3d(half.x(), half.y(), low + 2 * half.z()));
  return box;
}

Eigen::AlignedBox3d extentOf(const Shape& shape) {
  Eigen::AlignedBox3d whole;
  for (const ShapeBody& body : shape.bodies) {
    const Eigen::AlignedBox3d own = extentOf(body);
    if (own.isEmpty()) continue;
    for (int corner = 0; corner < 8; ++corner)
      whole.extend(Vector3d(body.X_SB * own.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
  }
  return whole;
}

std::vector<ShapeBody> sketch(ToolPicture picture, std::optional<Vector3d> size) {
  const Vector3d fill = size && size->minCoeff() > 0 ? *size : usualSize(picture);
  switch (picture) {
    case ToolPicture::mesh:
      return {};
    case ToolPicture::gripper: {
      const double body = whole(0.58 * fill.z());
      return {primitive(BodyKind::box, {fill.x(), fill.y(), body}, 0),
              primitive(BodyKind::box, {0.33 * fill.x(), 0.72 * fill.y(), std::max(1e-3, fill.z() - body)}, body)};
    }
    case ToolPicture::several: {
      const double body = whole(0.5 * fill.z());
      return {primitive(BodyKind::box, {fill.x(), fill.y(), body}, 0),
              primitive(BodyKind::cylinder, {0.5 * fill.x(), 0.5 * fill.x(), std::max(1e-3, fill.z() - body)}, body)};
    }
    default:
      return {primitive(*bodyKindOf(picture), fill, 0)};
  }
}

ShapeBody nextBody(BodyKind kind, const Shape& shape) {
  const auto taken = extentOf(shape);
  return primitive(kind, {0.030, 0.030, 0.040}, taken.isEmpty() ? 0.0 : taken.max().z());
}

double likelyUnit(double longestInFile) {
  // Tools are between 2 cm and 1 m long; of two units that fit, the one that CAD programs write more often.
  if (longestInFile >= 20.0) return 0.001;
  if (longestInFile > 1.5) return 0.01;
  return 1.0;
}

std::optional<double> materialVolume(const ShapeBody& body) {
  Shape alone;
  alone.bodies = {body};
  alone.bodies[0].mass.reset();
  alone.bodies[0].density.reset();
  if (body.kind == BodyKind::mesh || !whyInvalid(alone).empty()) return std::nullopt;
  return primitiveMoments(body)(3, 3);
}

std::optional<double> wallLimit(const ShapeBody& body) {
  if (body.kind == BodyKind::mesh || body.kind == BodyKind::tube || !materialVolume([&] {
        ShapeBody solid = body;
        solid.wall.reset();
        return solid;
      }()))
    return std::nullopt;
  return inradius(body);
}

}  // namespace heft
