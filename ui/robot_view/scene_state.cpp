#include "ui/robot_view/scene_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace heft {
namespace {

std::vector<Vector3d> someOf(const std::vector<Eigen::Vector3f>& vertices, std::size_t count, const Isometry3d& X,
                             const Vector3d& scale) {
  std::vector<Vector3d> points;
  const std::size_t stride = std::max<std::size_t>(1, vertices.size() / count);
  for (std::size_t v = 0; v < vertices.size(); v += stride)
    points.push_back(X * Vector3d(scale.cwiseProduct(vertices[v].cast<double>())));
  return points;
}

/// Of a box, cylinder or sphere.
std::vector<Vector3d> simpleSurface(const Visual& visual) {
  std::vector<Vector3d> points;
  if (visual.kind == Visual::Kind::box) {
    for (const double x : {-0.5, 0.0, 0.5})
      for (const double y : {-0.5, 0.0, 0.5})
        for (const double z : {-0.5, 0.0, 0.5}) points.push_back(visual.size.cwiseProduct(Vector3d(x, y, z)));
  } else {
    const bool ball = visual.kind == Visual::Kind::sphere;
    const double radius = visual.size.x();
    constexpr int kRings = 6, kAround = 24;
    for (int ring = 0; ring <= kRings; ++ring) {
      const double share = 2.0 * ring / kRings - 1.0;  // From -1 to 1
      const double z = ball ? radius * share : 0.5 * visual.size.y() * share;
      const double r = ball ? radius * std::sqrt(1.0 - share * share) : radius;
      for (int k = 0; k < kAround; ++k)
        points.emplace_back(r * std::cos(2 * std::numbers::pi * k / kAround),
                            r * std::sin(2 * std::numbers::pi * k / kAround), z);
    }
  }
  for (Vector3d& point : points) point = visual.X_LV * point;
  return points;
}

bool sameForm(const ShapeBody& a, const ShapeBody& b) {
  return a.kind == b.kind && a.dims == b.dims && a.mesh == b.mesh && a.unit == b.unit && a.wall == b.wall;
}

}  // namespace

void SceneState::setRobot(std::shared_ptr<const RobotLook> robot, std::vector<bool> beyond) {
  look = std::move(robot);
  ghostLinks = std::move(beyond);
  X_BL.clear();
  auto surfaces = std::make_shared<std::vector<LinkSurface>>();
  if (look) {
    for (const LookPart& part : look->parts) {
      if (!part.mesh) {
        surfaces->push_back({part.link, simpleSurface(part.visual)});
        continue;
      }
      for (const MeshPart& mesh : part.mesh->parts)
        surfaces->push_back({part.link, someOf(mesh.vertices, 500, part.visual.X_LV, part.visual.size)});
    }
  }
  surfaces_ = std::move(surfaces);
}

void SceneState::setTool(const std::vector<ShapeBody>& bodies, int selected) {
  selected_ = selected;
  tool_.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i >= bodies_.size() || !sameForm(bodies_[i], bodies[i]))
      tool_[i].solid = std::make_shared<const ToolSolid>(makeToolSolid(bodies[i]));
    tool_[i].X_SB = bodies[i].X_SB;
  }
  bodies_ = bodies;
}

void SceneState::addTool(std::vector<Vector3d>& points) const {
  for (const ToolBody& body : tool_)
    for (const Vector3d& p : someOf(body.solid->faces.vertices, 200, X_BS * body.X_SB, Vector3d::Ones()))
      points.push_back(p);
}

std::vector<Vector3d> SceneState::outline() const {
  std::vector<Vector3d> points;
  if (surfaces_) {
    for (const LinkSurface& surface : *surfaces_) {
      if (surface.link >= static_cast<int>(X_BL.size())) continue;
      for (std::size_t i = 0; i < surface.points.size(); i += 4)
        points.push_back(X_BL[static_cast<std::size_t>(surface.link)] * surface.points[i]);
    }
  }
  if (path)
    for (const PathSample& sample : *path) points.push_back(sample.point);
  addTool(points);
  if (sensorShown) {
    // Room for the arrows up and down, of which the way of the sensor says nothing.
    for (const double z : {-kGravityArrow, kFullArrow}) points.push_back(X_BS.translation() + Vector3d(0, 0, z));
    for (int a = 0; a < 3; ++a) points.push_back(X_BS * Vector3d(kAxisLength * Vector3d::Unit(a)));
  }
  if (points.empty()) points = {Vector3d(-0.3, -0.3, 0), Vector3d(0.5, 0.3, 0.8)};
  return points;
}

std::vector<Vector3d> SceneState::toolOutline(bool alone) const {
  std::vector<Vector3d> points;
  if (alone) {
    // A hand's breadth of the arm shows where the tool is.
    for (const double z : {-0.10, 0.09})
      for (int a = 0; a < 2; ++a)
        for (const double side : {-0.08, 0.08})
          points.push_back(X_BS * Vector3d(side * Vector3d::Unit(a) + Vector3d(0, 0, z)));
  } else {
    const Vector3d at = X_BS.translation();
    const Vector3d centre = payload ? Vector3d(X_BS * payload->com) : at;
    points = {at + Vector3d(0, 0, kFullArrow), centre - Vector3d(0, 0, kGravityArrow)};
    for (int a = 0; a < 3; ++a)
      for (const double side : {-1.0, 1.0}) points.push_back(centre + 0.16 * side * Vector3d::Unit(a));
  }
  addTool(points);
  return points;
}

std::vector<Vector3d> SceneState::surface() const {
  std::vector<Vector3d> points;
  if (surfaces_) {
    for (const LinkSurface& each : *surfaces_) {
      if (each.link >= static_cast<int>(X_BL.size())) continue;
      for (const Vector3d& p : each.points) points.push_back(X_BL[static_cast<std::size_t>(each.link)] * p);
    }
  }
  if (sensorShown) {
    for (int i = 0; i < 24; ++i)
      points.push_back(X_BS * Vector3d(kSensorRadius * std::cos(i * std::numbers::pi / 12),
                                       kSensorRadius * std::sin(i * std::numbers::pi / 12), -0.02));
  }
  addTool(points);
  return points;
}

std::vector<std::vector<Vector3d>> SceneState::namedPieces() const {
  std::vector<std::vector<Vector3d>> pieces;
  if (!sensorShown) return pieces;
  std::vector<Vector3d> disc;
  for (int i = 0; i < 12; ++i)
    for (const double z : {0.0, -sensorLength})
      disc.push_back(X_BS * Vector3d(kSensorRadius * std::cos(i * std::numbers::pi / 6),
                                     kSensorRadius * std::sin(i * std::numbers::pi / 6), z));
  pieces.push_back(std::move(disc));
  if (parts.tool)
    for (const ToolBody& body : tool_)
      pieces.push_back(someOf(body.solid->faces.vertices, 60, X_BS * body.X_SB, Vector3d::Ones()));
  // A slanting arrow is no rectangle: its short lengths are.
  const auto addArrow = [&](const Vector3d& from, const Vector3d& to) {
    constexpr int kLengths = 5;
    for (int k = 0; k < kLengths; ++k)
      pieces.push_back({from + (to - from) * k / kLengths, from + (to - from) * (k + 1) / kLengths});
  };
  Vector3d centre = X_BS.translation();
  if (payload && parts.payload) {
    centre = X_BS * payload->com;
    std::vector<Vector3d> region;
    for (int a = 0; a < 3; ++a)
      for (const double side : {-1.0, 1.0})
        region.push_back(centre +
                         X_BS.linear() * (side * payload->enlargement * payload->region(a) * Vector3d::Unit(a)));
    pieces.push_back(std::move(region));
  }
  if (parts.arrows) addArrow(centre, centre + kGravityArrow * down);
  if (parts.arrows && wrench) addArrow(X_BS.translation(), forceEnd());
  for (int a = 0; a < 3; ++a)
    if (parts.axes) addArrow(X_BS.translation(), X_BS * Vector3d(1.12 * kAxisLength * Vector3d::Unit(a)));
  return pieces;
}

Vector3d SceneState::forceEnd() const {
  const Vector3d f = wrench->head<3>() * (kFullArrow / std::max(1e-9, fullForce));
  // Spikes and contact would reach out of the picture.
  return X_BS.translation() + (f.norm() > 2 * kFullArrow ? Vector3d(f.normalized() * 2 * kFullArrow) : f);
}

SceneState::Anchors SceneState::anchors() const {
  Anchors anchors;
  if (!sensorShown) return anchors;
  for (int a = 0; a < 3; ++a)
    if (parts.axes) anchors.axes[a] = X_BS * Vector3d(1.12 * kAxisLength * Vector3d::Unit(a));
  anchors.sensor = X_BS * Vector3d(kSensorRadius, 0, -0.5 * sensorLength);
  Vector3d centre = X_BS.translation();
  if (payload && parts.payload) {
    centre = X_BS * payload->com;
    anchors.centre = centre;
    if (payload->boxEdges) anchors.box = centre + X_BS.linear() * payload->R_SBox * (0.5 * *payload->boxEdges);
  }
  if (parts.arrows) anchors.gravity = centre + kGravityArrow * down;
  if (parts.arrows && wrench) anchors.wrench = forceEnd();
  return anchors;
}

}  // namespace heft
