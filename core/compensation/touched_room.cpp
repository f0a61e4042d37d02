#include "core/compensation/touched_room.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "core/base/say.h"
#include "core/base/time_span.h"
#include "core/collision/tool_outline.h"
#include "core/math/statistics.h"
#include "core/motion/motion.h"

namespace heft {

namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr double kLeastForce = 2.0;                        ///< Less has no direction beside what is left of a load [N]
constexpr double kSteadyDirection = 25.0 * kRadPerDegree;  ///< Rubbing with a friction of 0.4 stays within it
constexpr double kSteadyPlace = 0.01;                      ///< What moves farther under the tool is no wall [m]
constexpr double kSliding = 0.6;                           ///< Sine of 37 degrees
constexpr double kSlides = 1e-5;  ///< From one row to the next but one; less has no direction [m]
constexpr double kSamePlane = 15.0 * kRadPerDegree, kSamePlace = 0.02;  ///< Two touches of one plane [m]

/// Rows of a touch, with the tool's pose and what presses on it, base axes.
struct Touch {
  double from = 0.0, to = 0.0;
  std::vector<Isometry3d> X_BS;
  std::vector<Vector3d> force;
};

Touch touchOf(const PhaseSegment& contact, const Compensated& compensated, const Motion& motion) {
  Touch out{contact.from, contact.to, {}, {}};
  const double enough = std::max(kLeastForce, 0.5 * contact.peakForce);
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    const double t = motion.time(k);
    if (t < contact.from || t > contact.to) continue;
    const double* begin = compensated.time.data();
    const auto row = std::min<Eigen::Index>(std::lower_bound(begin, begin + compensated.time.size(), t) - begin,
                                            compensated.time.size() - 1);
    const Vector3d pressed = -compensated.wrench.row(row).head<3>().transpose();
    if (pressed.norm() < enough) continue;
    Isometry3d X_BS = Isometry3d::Identity();
    X_BS.linear() = motion.R_BS[static_cast<std::size_t>(k)];
    X_BS.translation() = motion.position.col(k);
    out.X_BS.push_back(X_BS);
    out.force.emplace_back(X_BS.linear() * pressed);
  }
  return out;
}

/// Where the tool ends against `normal`, at each row of a touch.
std::vector<Vector3d> endsOf(const Touch& touch, const Eigen::Matrix3Xd& tool, const Vector3d& normal,
                             std::vector<Vector3d>& moves) {
  std::vector<Vector3d> ends;
  moves.clear();
  for (std::size_t i = 0; i < touch.X_BS.size(); ++i) {
    Eigen::Index lowest = 0;
    ((touch.X_BS[i].linear().transpose() * normal).transpose() * tool).minCoeff(&lowest);
    const Vector3d point = tool.col(lowest);
    ends.emplace_back(touch.X_BS[i] * point);
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, touch.X_BS.size() - 1);
    moves.emplace_back(touch.X_BS[after] * point - touch.X_BS[before] * point);
  }
  return ends;
}

/// `normal`, or the nearest direction along or across `up` where that is within `spread` [rad]: tables are level, walls
/// are plumb, and a hand's pressing tells a direction to several degrees only.
Vector3d plumb(const Vector3d& normal, const Vector3d& up, double spread) {
  const double along = normal.dot(up);
  if (std::acos(std::min(1.0, std::abs(along))) < spread) return std::copysign(1.0, along) * up;
  if (std::asin(std::min(1.0, std::abs(along))) < spread) return (normal - along * up).normalized();
  return normal;
}

/// The plane that a touch tells, or why it tells none. What presses is the normal's and friction's, and friction is
/// along the way that the tool slides. `up` against gravity, base axes.
Result<TouchedPlane> planeOf(const Touch& touch, const Eigen::Matrix3Xd& tool, const Vector3d& up) {
  if (touch.force.empty()) return Error{heft::say("it is pressed with less than {:.0f} N", kLeastForce)};
  Vector3d normal = Vector3d::Zero();
  for (const Vector3d& force : touch.force) normal += force;
  normal.normalize();
  std::vector<Vector3d> moves, pressing, ends = endsOf(touch, tool, normal, moves);
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    pressing = touch.force;
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < pressing.size(); ++i) {
      // Taken as it is and not across `normal`, which friction has tilted; unless it is rather pressed in than slid.
      const Vector3d& along = moves[i];
      if (along.norm() > kSlides && std::abs(normal.dot(along)) < kSliding * along.norm())
        pressing[i] -= pressing[i].dot(along) / along.squaredNorm() * along;
      sum += pressing[i];
    }
    normal = sum.normalized();
    ends = endsOf(touch, tool, normal, moves);
  }
  TouchedPlane out;
  const auto count = static_cast<double>(ends.size());
  double turned = 0.0;
  for (const Vector3d& force : pressing)
    turned += std::pow(std::acos(std::clamp(force.normalized().dot(normal), -1.0, 1.0)), 2);
  out.normalSpread = std::sqrt(turned / count);
  const Vector3d square = plumb(normal, up, out.normalSpread);
  out.plumb = square != normal;
  normal = square;
  ends = endsOf(touch, tool, normal, moves);
  std::vector<double> heights;
  Vector3d place = Vector3d::Zero();
  for (const Vector3d& end : ends) {
    heights.push_back(normal.dot(end));
    place += end;
  }
  out.offsetSpread = robustStd(heights);
  place /= count;
  out.plane = {place + (median(heights) - normal.dot(place)) * normal, normal};
  out.when = {{touch.from, touch.to}};
  if (out.normalSpread > kSteadyDirection)
    return Error{heft::say("the direction of the force varies by {:.0f} degrees", out.normalSpread / kRadPerDegree)};
  if (out.offsetSpread > kSteadyPlace)
    return Error{heft::say("it moves by {:.0f} mm while it is pressed", 1e3 * out.offsetSpread)};
  return out;
}

bool isSame(const TouchedPlane& a, const TouchedPlane& b) {
  return std::acos(std::clamp(a.plane.normal.dot(b.plane.normal), -1.0, 1.0)) < kSamePlane &&
         std::abs(a.plane.normal.dot(b.plane.point - a.plane.point)) < kSamePlace;
}

/// Weighted by their touches.
void join(TouchedPlane& into, const TouchedPlane& other) {
  const double n = static_cast<double>(into.when.size());
  into.offsetSpread = std::max({into.offsetSpread, other.offsetSpread,
                                0.5 * std::abs(into.plane.normal.dot(other.plane.point - into.plane.point))});
  into.plumb = into.plumb && other.plumb;
  into.plane.normal = (n * into.plane.normal + other.plane.normal).normalized();
  into.plane.point = (n * into.plane.point + other.plane.point) / (n + 1.0);
  into.normalSpread = std::max(into.normalSpread, other.normalSpread);
  into.when.push_back(other.when.front());
}

}  // namespace

Result<TouchedRoom> touchedRoom(const Recording& recording, const RobotModel* robot, const Compensated& compensated,
                                const Shape& tool) {
  const auto motion = motionOf(recording, robot, MotionOptions{});
  if (!motion) return motion.error();
  if (motion->position.cols() != motion->size() || !motion->position.allFinite())
    return Error{heft::say("Where the tool was is not known: joint angles, or poses with positions, are needed.")};
  TouchedRoom out;
  const auto outlines = outlinesOf(tool, out.findings);
  if (!outlines) return outlines.error();
  Eigen::Index count = 0;
  for (const auto& body : *outlines) count += body.cols();
  Eigen::Matrix3Xd points(3, count);
  count = 0;
  for (const auto& body : *outlines) {
    points.middleCols(count, body.cols()) = body;
    count += body.cols();
  }
  const Vector3d up = (Vector3d::Zero() - recording.meta.gravity).normalized();  // No -0
  for (const PhaseSegment& segment : compensated.segments) {
    if (segment.phase != Phase::contact) continue;
    const auto plane = planeOf(touchOf(segment, compensated, *motion), points, up);
    if (!plane) {
      out.findings.push_back({Severity::info,
                              "touch_without_plane",
                              heft::say("The contact from {} gives no plane: {}.", timeSpan(segment.from, segment.to),
                                        plane.error().message),
                              heft::say("Press the tool against the wall or table and hold it for a second."),
                              {}});
      continue;
    }
    const auto known = std::ranges::find_if(out.planes, [&](const TouchedPlane& p) { return isSame(p, *plane); });
    if (known == out.planes.end())
      out.planes.push_back(*plane);
    else
      join(*known, *plane);
  }
  return out;
}

Result<TouchedRoom> findTouchedRoom(const Recording& recording, const RobotModel* robot, const nlohmann::json& result,
                                    const std::string& where, const Shape& tool, const Progress& progress) {
  const auto settings = compensateOptionsFromJson(result, where);
  if (!settings) return settings.error();
  const auto compensated = compensate(recording, robot, *settings, progress);
  if (!compensated) return compensated.error();
  auto touched = touchedRoom(recording, robot, *compensated, tool);
  if (!touched || !touched->planes.empty()) return touched;
  std::string why = heft::say(
      "{} contains no contact that defines a plane. Press the tool against each wall or table and hold it for a "
      "second, with free motion between.",
      recording.file);
  for (const Finding& finding : touched->findings) why += " " + finding.text;
  return Error{why};
}

Room roomOf(const TouchedRoom& touched, double margin) {
  constexpr double kUpright = 0.8;  // cos 37 degrees
  const auto kindOf = [](const TouchedPlane& p) -> std::string {
    return p.plane.normal.z() > kUpright ? "table" : p.plane.normal.z() < -kUpright ? "ceiling" : "wall";
  };
  std::map<std::string, int> counts, used;
  for (const auto& plane : touched.planes) ++counts[kindOf(plane)];
  Room room;
  room.margin = margin;
  for (const auto& plane : touched.planes) {
    const std::string kind = kindOf(plane);
    room.obstacles.push_back({counts[kind] > 1 ? fmt::format("{} {}", kind, ++used[kind]) : kind, plane.plane});
  }
  return room;
}

}  // namespace heft
