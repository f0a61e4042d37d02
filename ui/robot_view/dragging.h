#pragma once
// Where the pointer drags something to: rays of the camera against lines, planes and circles. Free of Qt and VTK.
#include <optional>

#include "ui/robot_view/orbit_camera.h"

namespace heft {

/// How far along the line from `point` in direction `axis` (unit) the ray comes nearest [m]; nothing where they run
/// almost alongside each other.
std::optional<double> alongLine(const Ray& ray, const Vector3d& point, const Vector3d& axis);

/// Where the ray meets the plane through `point`; nothing if it runs along it or away from it.
std::optional<Vector3d> onPlane(const Ray& ray, const Vector3d& point, const Vector3d& normal);

/// Angle [rad, (-pi, pi]] about `axis` from the direction `from` to the direction `to`, both from the circle's centre.
double angleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to);

}  // namespace heft
