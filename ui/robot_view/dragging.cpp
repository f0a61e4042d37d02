#include "ui/robot_view/dragging.h"

#include <cmath>

namespace heft {
namespace {
/// Nearer to a line or plane than this (sine of the angle) a pixel would be worth a leap.
constexpr double kLeastSine = 0.15;
}  // namespace

std::optional<double> alongLine(const Ray& ray, const Vector3d& point, const Vector3d& axis) {
  const double b = ray.direction.dot(axis), sineSquared = 1.0 - b * b;
  if (sineSquared < kLeastSine * kLeastSine) return std::nullopt;
  const Vector3d d = ray.origin - point;
  return (d.dot(axis) - b * d.dot(ray.direction)) / sineSquared;
}

std::optional<Vector3d> onPlane(const Ray& ray, const Vector3d& point, const Vector3d& normal) {
  const double sine = ray.direction.dot(normal);
  if (std::abs(sine) < kLeastSine) return std::nullopt;
  const double distance = (point - ray.origin).dot(normal) / sine;
  if (distance <= 0) return std::nullopt;
  return ray.origin + distance * ray.direction;
}

double angleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  const Vector3d a = from - axis * axis.dot(from), b = to - axis * axis.dot(to);
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

}  // namespace heft
