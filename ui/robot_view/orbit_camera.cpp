#include "ui/robot_view/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace heft {
namespace {
/// Just short of the poles, where the vertical would be lost.
constexpr double kSteepest = std::numbers::pi / 2 - 0.01;
}  // namespace

Vector3d OrbitCamera::position() const {
  const double c = std::cos(elevation);
  return target + distance * Vector3d(c * std::cos(azimuth), c * std::sin(azimuth), std::sin(elevation));
}

Vector3d OrbitCamera::up() const { return Vector3d::UnitZ(); }

Vector3d OrbitCamera::right() const { return Vector3d(-std::sin(azimuth), std::cos(azimuth), 0.0); }

Vector3d OrbitCamera::pictureUp() const { return (position() - target).normalized().cross(right()); }

Eigen::Vector2d OrbitCamera::pixelOf(const Vector3d& point, double width, double height) const {
  const Vector3d d = point - position(), forward = (target - position()).normalized();
  const double depth = d.dot(forward);
  if (depth <= 1e-6) return {-1e6, -1e6};
  const double scale = height / (2.0 * std::tan(viewAngle / 2.0) * depth);
  return {width / 2 + scale * d.dot(right()), height / 2 - scale * d.dot(pictureUp())};
}

Ray OrbitCamera::rayThrough(const Eigen::Vector2d& pixel, double width, double height) const {
  const double perPixel = 2.0 * std::tan(viewAngle / 2.0) / std::max(1.0, height);
  const Vector3d forward = (target - position()).normalized();
  const Vector3d d = forward + perPixel * ((pixel.x() - width / 2) * right() - (pixel.y() - height / 2) * pictureUp());
  return {position(), d.normalized()};
}

double OrbitCamera::metresPerPixel(const Vector3d& point, double height) const {
  const double depth = (point - position()).dot((target - position()).normalized());
  return std::max(1e-9, depth) * 2.0 * std::tan(viewAngle / 2.0) / std::max(1.0, height);
}

void OrbitCamera::orbit(double dx, double dy) {
  azimuth = std::remainder(azimuth - dx * 0.008, 2.0 * std::numbers::pi);
  elevation = std::clamp(elevation + dy * 0.006, -0.35, kSteepest);
}

void OrbitCamera::pan(double dx, double dy, int viewportHeight) {
  const double metresPerPixel = 2.0 * distance * std::tan(viewAngle / 2.0) / std::max(1, viewportHeight);
  target += metresPerPixel * (-dx * right() + dy * pictureUp());
}

void OrbitCamera::dolly(double factor) { distance = std::clamp(distance * factor, 0.15, 12.0); }

void OrbitCamera::fit(const std::vector<Vector3d>& points, double aspect, double margin, double marginRight) {
  if (points.empty()) return;
  const Vector3d r = right(), u = pictureUp(), toEye = (position() - target).normalized();
  const double tanUp = std::tan(viewAngle / 2.0), tanRight = tanUp * std::max(0.1, aspect);
  // In the picture's coordinates (-1 to 1) the points may fill this window.
  const double left = -1 + 2 * margin, wide = 1 - 2 * marginRight, low = -1 + 2 * margin, high = 1 - 2 * margin;
  target = Vector3d::Zero();
  for (const Vector3d& p : points) target += p / static_cast<double>(points.size());
  // The picture of a point depends on the distance, which depends on the points: a few rounds settle it.
  for (int round = 0; round < 12; ++round) {
    double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9;
    for (const Vector3d& p : points) {
      const Vector3d d = p - target;
      const double depth = std::max(0.05, distance - d.dot(toEye));
      const double x = d.dot(r) / (depth * tanRight), y = d.dot(u) / (depth * tanUp);
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
    const double scale = std::max({(x1 - x0) / (wide - left), (y1 - y0) / (high - low), 1e-3});
    target += distance * (tanRight * ((x0 + x1) / 2 - (left + wide) / 2 * scale) * r +
                          tanUp * ((y0 + y1) / 2 - (low + high) / 2 * scale) * u);
    distance = std::clamp(distance * scale, 0.15, 12.0);
  }
}

void turnTo(OrbitCamera& camera, ViewPreset preset) {
  switch (preset) {
    case ViewPreset::overview:
      camera.azimuth = -0.95;
      camera.elevation = 0.20;
      break;
    case ViewPreset::front:
      camera.azimuth = 0.0;
      camera.elevation = 0.05;
      break;
    case ViewPreset::side:
      camera.azimuth = -std::numbers::pi / 2;
      camera.elevation = 0.05;
      break;
    case ViewPreset::top:
      camera.azimuth = -std::numbers::pi / 2;
      camera.elevation = kSteepest;
      break;
    case ViewPreset::tool:
      camera.elevation = std::clamp(camera.elevation, 0.0, 0.35);
      break;
  }
}

void turnToAxes(OrbitCamera& camera, const Matrix3d& axes) {
  constexpr double kEnough = 0.5;  // Sine of the angle between an axis and the line of sight.
  const OrbitCamera before = camera;
  double most = -1e9;
  for (int a = -18; a < 18; ++a) {
    for (const double elevation : {before.elevation, 0.2, 0.4, 0.6}) {
      OrbitCamera tried = before;
      tried.azimuth = before.azimuth + a * std::numbers::pi / 18;
      tried.elevation = elevation;
      const Vector3d sight = (tried.target - tried.position()).normalized();
      double least = kEnough;
      for (int i = 0; i < 3; ++i) least = std::min(least, sight.cross(axes.col(i)).norm());
      const double score =
          4 * least - 0.12 * std::abs(a * std::numbers::pi / 18) - 0.3 * std::abs(elevation - before.elevation);
      if (score <= most) continue;
      most = score;
      camera = tried;
    }
  }
  camera.azimuth = std::remainder(camera.azimuth, 2 * std::numbers::pi);
}

}  // namespace heft
