#include "core/collision/clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/library_on_demand.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/collision/course.h"
#include "core/collision/fcl_bodies.h"
#include "core/collision/hull.h"
#include "core/collision/link_bodies.h"
#include "core/collision/tool_outline.h"
#include "core/payload/shape_prior.h"

namespace heft {

namespace {

const LibraryOnDemand fclLibrary{HEFT_FCL_LIBRARY, ""};
const FunctionOnDemand<decltype(::heft_make_fcl_body)> makeFclBody{fclLibrary, "heft_make_fcl_body"};
const FunctionOnDemand<decltype(::heft_delete_fcl_body)> deleteFclBody{fclLibrary, "heft_delete_fcl_body"};
const FunctionOnDemand<decltype(::heft_between_convex)> betweenConvex{fclLibrary, "heft_between_convex"};
const FunctionOnDemand<decltype(::heft_between_surfaces)> betweenTriangles{fclLibrary, "heft_between_surfaces"};

constexpr int kWorld = -1;
constexpr double kAlways = std::numeric_limits<double>::infinity();  ///< No lower bound is enough

/// A body of arm, tool or room.
struct CollisionBody {
  std::string name;
  int link = kWorld;
  Eigen::Matrix3Xd vertices;           ///< Link axes; the room's: base axes [m]
  std::optional<ConvexHull> hull;      ///< Solid; nothing: a surface
  std::optional<RoomPlane> plane;      ///< All behind it is closed; then there is nothing else.
  std::shared_ptr<const FclBody> fcl;  ///< The hull or the surface; none of a plane
  Vector3d centre = Vector3d::Zero();  ///< Of a ball around it
  double radius = 0.0;
};

std::shared_ptr<const FclBody> fclBody(const Eigen::Matrix3Xd& vertices,
                                       const std::vector<std::array<int, 3>>& triangles, bool convex) {
  return {makeFclBody(vertices, triangles, convex), [](FclBody* body) { deleteFclBody(body); }};
}

void setBall(CollisionBody& body) {
  const Vector3d low = body.vertices.rowwise().minCoeff(), high = body.vertices.rowwise().maxCoeff();
  body.centre = 0.5 * (low + high);
  body.radius = (body.vertices.colwise() - body.centre).colwise().norm().maxCoeff();
}

Result<CollisionBody> solid(std::string name, int link, const Eigen::Matrix3Xd& points) {
  auto hull = convexHull(points);
  if (!hull) return Error{fmt::format("{}: {}", name, hull.error().message)};
  CollisionBody body;
  body.name = std::move(name);
  body.link = link;
  body.vertices = hull->vertices;
  body.fcl = fclBody(hull->vertices, hull->triangles, true);
  body.hull = std::move(*hull);
  setBall(body);
  return body;
}

Result<CollisionBody> bodyOf(const Obstacle& obstacle) {
  if (const auto* plane = std::get_if<RoomPlane>(&obstacle.body)) {
    CollisionBody body;
    body.name = titleOf(obstacle);
    body.plane = *plane;
    return body;
  }
  if (const auto* box = std::get_if<RoomBox>(&obstacle.body))
    return solid(titleOf(obstacle), kWorld, box->X_BO * boxCorners(box->size));
  const auto& mesh = std::get<RoomMesh>(obstacle.body);
  CollisionBody body;
  body.name = titleOf(obstacle);
  std::vector<std::array<int, 3>> triangles;
  std::vector<Vector3d> points;
  for (const auto& part : mesh.mesh->parts) {
    const int first = static_cast<int>(points.size());
    for (const auto& v : part.vertices) points.emplace_back(mesh.X_BO * (mesh.unit * v.cast<double>()));
    for (const auto& t : part.triangles)
      triangles.push_back(
          {first + static_cast<int>(t[0]), first + static_cast<int>(t[1]), first + static_cast<int>(t[2])});
  }
  body.vertices = columnsOf(points);
  body.fcl = fclBody(body.vertices, triangles, false);
  setBall(body);
  return body;
}

/// The tool's bodies in the link's axes, each grown about its own middle.
Result<std::vector<CollisionBody>> toolBodies(const HeldTool& tool, Findings& findings) {
  constexpr double kInterval = 1.96;  // 95 % of a normal distribution
  auto outlines = outlinesOf(*tool.shape, findings);
  if (!outlines) return outlines.error();
  std::vector<CollisionBody> out;
  const std::size_t count = outlines->size();
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Matrix3Xd& points = (*outlines)[i];
    const double stretch = trustIn(tool.shape->certainty, tool.shape->bodies[i].kind, static_cast<int>(count)).stretch;
    const Vector3d middle = 0.5 * (points.rowwise().minCoeff() + points.rowwise().maxCoeff());
    points = ((1.0 + kInterval * stretch) * (points.colwise() - middle)).colwise() + middle;
    auto made = solid(count == 1 ? heft::say("the tool") : heft::say("part {} of the tool", i + 1), tool.link,
                      tool.X_LS * points);
    if (!made) return made.error();
    out.push_back(std::move(*made));
  }
  return out;
}

}  // namespace

struct Clearance::Impl {
  const RobotModel* robot = nullptr;
  double margin = 0.02;
  std::vector<CollisionBody> bodies;
  struct Pair {
    std::size_t a = 0, b = 0;
    double margin = 0.0;
    bool ofArm = false;  ///< Both are links of the arm, nothing is of tool or room.
    VectorXd reach;      ///< How far a joint moves the one against the other at most [m/rad], one a column of q
  };
  std::vector<Pair> pairs;

  Isometry3d poseOf(const CollisionBody& body, const VectorXd& q) const {
    return body.link == kWorld ? Isometry3d(Isometry3d::Identity()) : robot->linkPose(q, body.link);
  }

  /// How far apart the hulls of two bodies are along `direction` (unit length, base axes): their distance is no less.
  static double apartAlong(const Vector3d& direction, const CollisionBody& a, const Isometry3d& X_Ba,
                           const CollisionBody& b, const Isometry3d& X_Bb) {
    const Vector3d in_a = X_Ba.linear().transpose() * direction, in_b = X_Bb.linear().transpose() * direction;
    return (in_b.transpose() * b.vertices).minCoeff() - (in_a.transpose() * a.vertices).maxCoeff() +
           direction.dot(X_Bb.translation() - X_Ba.translation());
  }

  /// Of two hulls. FCL's search for the nearest points of convex bodies ends too early now and then, with a distance
  /// that is millimetres too large: the direction that it finds proves a distance, and where that is less than it says,
  /// the surfaces' triangles are compared. `direction` gets it.
  static double betweenHulls(const CollisionBody& a, const Isometry3d& X_Ba, const CollisionBody& b,
                             const Isometry3d& X_Bb, Vector3d& direction) {
    constexpr double kPrecise = 1e-4;  // [m]
    NearestPoints points;
    const double said = betweenConvex(*a.fcl, X_Ba, *b.fcl, X_Bb, points);
    if (said > 0.0) {
      const Vector3d across = points[1] - points[0];
      if (across.norm() > 0.0) direction = across.normalized();
      const double proven = apartAlong(direction, a, X_Ba, b, X_Bb);
      if (proven > said - kPrecise) return proven;
    }
    return betweenSurfaces(a, X_Ba, b, X_Bb);
  }

  static double betweenSurfaces(const CollisionBody& a, const Isometry3d& X_Ba, const CollisionBody& b,
                                const Isometry3d& X_Bb) {
    const double between = betweenTriangles(*a.fcl, X_Ba, *b.fcl, X_Bb, nullptr);
    if (between <= 0.0) return 0.0;
    // Surfaces are apart, too, where one body lies wholly in the other.
    if (b.hull && b.hull->contains(X_Bb.inverse() * (X_Ba * Vector3d(a.vertices.col(0))))) return 0.0;
    if (a.hull && a.hull->contains(X_Ba.inverse() * (X_Bb * Vector3d(b.vertices.col(0))))) return 0.0;
    return between;
  }

  /// 0 where they touch or overlap. What is surely farther apart than `enough` may be told by a lower bound.
  /// `direction`: from a look before at the same pair, or any; gets the one that parts them best.
  double distance(const Pair& pair, const VectorXd& q, double enough, Vector3d& direction) const {
    const CollisionBody &a = bodies[pair.a], &b = bodies[pair.b];
    const Isometry3d X_Ba = poseOf(a, q);
    if (b.plane) {
      const Vector3d n_a = X_Ba.linear().transpose() * b.plane->normal;
      const double height = b.plane->normal.dot(X_Ba.translation() - b.plane->point);
      return std::max(0.0, height + (n_a.transpose() * a.vertices).minCoeff());
    }
    const Isometry3d X_Bb = poseOf(b, q);
    const double balls = (X_Ba * a.centre - X_Bb * b.centre).norm() - a.radius - b.radius;
    if (balls > enough) return balls;
    if (!b.hull) return betweenSurfaces(a, X_Ba, b, X_Bb);
    if (const double before = apartAlong(direction, a, X_Ba, b, X_Bb); before > enough) return before;
    return betweenHulls(a, X_Ba, b, X_Bb, direction);
  }

  Nearest named(const Pair& pair, double distance) const {
    Nearest out;
    out.first = bodies[pair.a].name;
    out.second = bodies[pair.b].name;
    out.distance = distance;
    out.margin = pair.margin;
    return out;
  }

  /// Where the two are nearest: two points, base axes. For a picture: where they overlap, the middle of the first.
  void setPoints(const Pair& pair, const VectorXd& q, Nearest& nearest) const {
    const CollisionBody &a = bodies[pair.a], &b = bodies[pair.b];
    const Isometry3d X_Ba = poseOf(a, q);
    if (b.plane) {
      Eigen::Index lowest = 0;
      ((X_Ba.linear().transpose() * b.plane->normal).transpose() * a.vertices).minCoeff(&lowest);
      nearest.onFirst = X_Ba * Vector3d(a.vertices.col(lowest));
      nearest.onSecond = nearest.onFirst - b.plane->normal.dot(nearest.onFirst - b.plane->point) * b.plane->normal;
      return;
    }
    // Of two meshes of one kind FCL tells the points in base axes.
    NearestPoints points;
    const bool apart = betweenTriangles(*a.fcl, X_Ba, *b.fcl, poseOf(b, q), &points) > 0.0;
    nearest.onFirst = apart ? points[0] : Vector3d(X_Ba * a.centre);
    nearest.onSecond = apart ? points[1] : nearest.onFirst;
  }

  /// Joints between the two bodies, and how far each reaches.
  VectorXd reachOf(const CollisionBody& a, const CollisionBody& b) const {
    VectorXd ofA = jointReach(*robot, a.link, a.vertices);
    if (b.link == kWorld) return ofA;
    const VectorXd ofB = jointReach(*robot, b.link, b.vertices);
    const std::vector<bool> both = sharedJoints(*robot, a.link, b.link);
    VectorXd out = VectorXd::Zero(robot->dof());
    for (Eigen::Index j = 0; j < out.size(); ++j)
      if (!both[static_cast<std::size_t>(j)]) out(j) = ofA(j) + ofB(j);
    return out;
  }
};

std::string Conflict::sentence() const {
  return bodies.distance > 0.0
             ? heft::say("{} and {} come within {:.0f} mm of each other, {:.1f} s into the motion.", bodies.first,
                         bodies.second, 1e3 * bodies.distance, time)
             : heft::say("{} and {} collide {:.1f} s into the motion.", bodies.first, bodies.second, time);
}

Clearance::Clearance(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Clearance::Clearance(Clearance&&) noexcept = default;
Clearance& Clearance::operator=(Clearance&&) noexcept = default;
Clearance::~Clearance() = default;

Result<Clearance> Clearance::of(const RobotModel& robot, const HeldTool& tool, const Room& room, Findings& findings) {
  if (auto missing = fclLibrary.problem(); !missing.empty()) return Error{std::move(missing)};
  auto impl = std::make_unique<Impl>();
  impl->robot = &robot;
  impl->margin = room.margin;
  auto links = linkBodies(robot, tool.shape ? std::optional(tool.link) : std::nullopt);
  if (!links) return links.error();
  for (auto& part : *links) {
    auto body = solid(part.name, part.link, part.points);
    if (!body) return body.error();
    impl->bodies.push_back(std::move(*body));
  }
  const std::size_t arm = impl->bodies.size();
  if (tool.shape) {
    auto bodies = toolBodies(tool, findings);
    if (!bodies) return bodies.error();
    for (auto& body : *bodies) impl->bodies.push_back(std::move(body));
  }
  const std::size_t own = impl->bodies.size();
  for (const auto& obstacle : room.obstacles) {
    auto body = bodyOf(obstacle);
    if (!body) return body.error();
    impl->bodies.push_back(std::move(*body));
  }
  const VectorXd home = robot.homePosture();
  std::set<std::string> coarse;
  for (std::size_t a = 0; a < own; ++a)
    for (std::size_t b = a + 1; b < impl->bodies.size(); ++b) {
      const CollisionBody &first = impl->bodies[a], &second = impl->bodies[b];
      // The arm's own controller keeps it off itself, and hulls are larger than links.
      Impl::Pair pair{a, b, b < arm ? 0.0 : impl->margin, b < arm, impl->reachOf(first, second)};
      // A pedestal stands where it stands, and neighbours turn about one joint: they are made not to meet.
      if (second.plane && !changesHeight(robot, first.link, second.plane->normal)) continue;
      if ((pair.reach.array() > 0.0).count() < (second.link == kWorld ? 1 : 2)) continue;
      Vector3d direction = Vector3d::UnitZ();
      if (second.link != kWorld && impl->distance(pair, home, kAlways, direction) <= pair.margin) {
        coarse.insert(heft::say("{} and {}", first.name, second.name));
        continue;
      }
      impl->pairs.push_back(std::move(pair));
    }
  if (!coarse.empty())
    findings.push_back(
        {Severity::info,
         "too_coarse_to_part",
         heft::say("Not checked against each other, since they are just as close in the home posture: {}.",
                   joined({coarse.begin(), coarse.end()})),
         {},
         {}});
  return Clearance(std::move(impl));
}

Nearest Clearance::nearest(const VectorXd& q) const {
  Nearest out;
  out.distance = kAlways;
  const Impl::Pair* nearest = nullptr;
  // Links of the wrist are always near each other, which tells nobody anything.
  const bool others = std::ranges::any_of(impl_->pairs, [](const Impl::Pair& pair) { return !pair.ofArm; });
  for (const auto& pair : impl_->pairs) {
    Vector3d direction = Vector3d::UnitZ();
    const double least = out.distance - out.margin;
    // Of two links that only must not touch it is enough to know that they are apart.
    const bool mayBeNear = others && pair.ofArm;
    const double d = impl_->distance(pair, q, (mayBeNear ? std::min(0.0, least) : least) + pair.margin, direction);
    if (d - pair.margin >= least || (mayBeNear && d > 0.0)) continue;
    out = impl_->named(pair, d);
    nearest = &pair;
  }
  if (nearest) impl_->setPoints(*nearest, q, out);
  return out;
}

std::vector<HullSurface> Clearance::hulls() const {
  std::vector<HullSurface> out;
  for (const CollisionBody& body : impl_->bodies)
    if (body.link != kWorld) out.push_back({body.link, body.hull->vertices, body.hull->triangles});
  return out;
}

std::optional<Conflict> Clearance::firstConflict(const JointMotion& motion) const {
  constexpr double kStep = 0.001;  // As near as this to the margin is within it [m]
  constexpr double kFar = 0.05;    // Beyond it a lower bound is good enough [m]
  std::optional<Conflict> out;
  if (motion.size() == 0) return out;
  const Course course(motion);
  VectorXd q;
  for (const auto& pair : impl_->pairs) {
    const VectorXd moved = course.movedBy(pair.reach);
    double t = motion.time(0);
    const double end = out ? out->time : motion.duration();
    Vector3d direction = Vector3d::UnitZ();
    double room = kFar;
    while (t <= end) {
      course.at(t, q);
      // Along the direction of before it may be proven that they are far enough apart for a step nearly as large.
      room = impl_->distance(pair, q, pair.margin + std::clamp(0.5 * room, kStep, kFar), direction) - pair.margin;
      if (room <= 0.0) {
        if (!out || t < out->time) out = Conflict{impl_->named(pair, std::max(0.0, room + pair.margin)), t};
        break;
      }
      t = course.untilMoved(moved, t, std::max(room, kStep));
    }
  }
  return out;
}

}  // namespace heft
