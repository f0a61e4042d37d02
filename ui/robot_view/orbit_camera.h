#pragma once
// A camera that circles a point with the vertical kept upright: azimuth, elevation, distance.
#include <vector>

#include "core/math/rigid.h"

namespace heft {

/// A half line in B.
struct Ray {
  Vector3d origin = Vector3d::Zero();      ///< [m]
  Vector3d direction = Vector3d::UnitX();  ///< Unit vector
};

struct OrbitCamera {
  Vector3d target{0.0, 0.0, 0.45};  ///< [m], B axes
  double azimuth = 0.6;             ///< [rad] about z; 0 looks along -x, from the front
  double elevation = 0.25;          ///< [rad] above the horizon
  double distance = 2.4;            ///< [m]
  double viewAngle = 0.5236;        ///< [rad], vertical

  Vector3d position() const;
  Vector3d up() const;
  /// Unit vectors of the picture: right and up.
  Vector3d right() const;
  Vector3d pictureUp() const;

  /// Where a point [m, B axes] is in a picture of this size [pixels, from the top left]; far outside if it is behind
  /// the camera.
  Eigen::Vector2d pixelOf(const Vector3d& point, double width, double height) const;
  /// The ray through a pixel.
  Ray rayThrough(const Eigen::Vector2d& pixel, double width, double height) const;
  /// Length that one pixel covers at this point's depth [m].
  double metresPerPixel(const Vector3d& point, double height) const;

  /// By pixels of a mouse drag.
  void orbit(double dx, double dy);
  void pan(double dx, double dy, int viewportHeight);
  /// Factor below 1 comes nearer.
  void dolly(double factor);
  /// Keeps its direction and moves so that all points fit a viewport of this aspect (width / height) with `margin`
  /// (share of the picture) free on every side, and `marginRight` at the right.
  void fit(const std::vector<Vector3d>& points, double aspect, double margin, double marginRight);
};

enum class ViewPreset { overview, front, side, top, tool };
/// Only the direction; for the tool the one that is, not too steep.
void turnTo(OrbitCamera& camera, ViewPreset preset);

/// Turns the camera as little as is needed for none of the axes to point at the viewer: what is dragged along them must
/// be seen from the side.
void turnToAxes(OrbitCamera& camera, const Matrix3d& axes);

}  // namespace heft
