#include "ui/robot_view/orbit_camera.h"

#include <algorithm>
#include <cmath>

namespace heft {
namespace {
constexpr double kPi = 3.14159265358979323846;
/// Just short of the poles, where the vertical would be lost.
constexpr double kSteepest = kPi / 2 - 0.01;
}  // namespace

Vector3d OrbitCamera::position() const {
  const double c = std::cos(elevation);
  return target + distance * Vector3d(c * std::cos(azimuth), c * std::sin(azimuth), std::sin(elevation));
}

Vector3d OrbitCamera::up() const { return Vector3d::UnitZ(); }

Vector3d OrbitCamera::right() const { return Vector3d(-std::sin(azimuth), std::cos(azimuth), 0.0); }

Vector3d OrbitCamera::pictureUp() const { return (position() - target).normalized().cross(right()); }

void OrbitCamera::orbit(double dx, double dy) {
  azimuth = std::remainder(azimuth - dx * 0.008, 2.0 * kPi);
  elevation = std::clamp(elevation + dy * 0.006, -0.35, kSteepest);
}

void OrbitCamera::pan(double dx, double dy, int viewportHeight) {
  const double metresPerPixel = 2.0 * distance * std::tan(viewAngle / 2.0) / std::max(1, viewportHeight);
  target += metresPerPixel * (-dx * right() + dy * pictureUp());
}

void OrbitCamera::dolly(double factor) { distance = std::clamp(distance * factor, 0.15, 12.0); }

void OrbitCamera::fit(const Vector3d& centre, double radius, double aspect) {
  target = centre;
  const double half = std::min(viewAngle / 2.0, std::atan(std::tan(viewAngle / 2.0) * std::max(0.1, aspect)));
  distance = std::clamp(radius / std::sin(half), 0.15, 12.0);
}

}  // namespace heft
