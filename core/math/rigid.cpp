#include "core/math/rigid.h"

#include <algorithm>
#include <cmath>

namespace heft {

Matrix3d skew(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Matrix3d rotationFromRpy(const Vector3d& rpy) {
  return (Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}

Vector3d rpyFromRotation(const Matrix3d& R) {
  const double sinPitch = std::clamp(-R(2, 0), -1.0, 1.0);
  const double cosPitch = std::hypot(R(0, 0), R(1, 0));
  const double pitch = std::atan2(sinPitch, cosPitch);
  if (cosPitch < 1e-9) return {std::atan2(-R(1, 2), R(1, 1)), pitch, 0.0};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

Matrix3d rotationFromVector(const Vector3d& phi) {
  const double angle = phi.norm();
  if (angle < 1e-12) return Matrix3d::Identity() + skew(phi);
  return Eigen::AngleAxisd(angle, phi / angle).toRotationMatrix();
}

Vector3d vectorFromRotation(const Matrix3d& R) {
  const Quaterniond q(R);
  const double sign = q.w() < 0 ? -1.0 : 1.0;
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * sign * q.vec();
  return sign * q.vec() / sine * 2.0 * std::atan2(sine, std::abs(q.w()));
}

Isometry3d poseFromXyzRpy(const Vector3d& xyz, const Vector3d& rpy) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = rotationFromRpy(rpy);
  X.translation() = xyz;
  return X;
}

}  // namespace heft
