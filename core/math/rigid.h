#pragma once
// Rotations and poses. Names follow the monogram rule: X_FS is the pose of S in F, R_WS turns S axes into W axes,
// p_SPcm_S runs from S's origin to Pcm in S axes. Frames: W world, B robot base, F flange, S sensor, Pcm centre of
// mass.
#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace heft {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Vector6d = Eigen::Matrix<double, 6, 1>;  ///< Wrench: force [N], then torque [N m].
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector10d = Eigen::Matrix<double, 10, 1>;
using Matrix10d = Eigen::Matrix<double, 10, 10>;

/// The matrix [v]x with skew(v) * u == v.cross(u).
Matrix3d skew(const Vector3d& v);

/// Fixed-axis roll, pitch, yaw [rad] as in URDF: R = Rz(yaw) Ry(pitch) Rx(roll).
Matrix3d rotationFromRpy(const Vector3d& rpy);

/// Inverse of rotationFromRpy; pitch in [-pi/2, pi/2]; at the pole yaw is 0.
Vector3d rpyFromRotation(const Matrix3d& R);

/// Rotation by the rotation vector `phi` [rad], and back (angle in [0, pi]).
Matrix3d rotationFromVector(const Vector3d& phi);
Vector3d vectorFromRotation(const Matrix3d& R);

/// Pose from position [m] and fixed-axis rpy [rad].
Isometry3d poseFromXyzRpy(const Vector3d& xyz, const Vector3d& rpy);

}  // namespace heft
