#include "core/wrench/regressor.h"

namespace heft {

namespace {

/// L(v) with L(v) [Ixx Ixy Ixz Iyy Iyz Izz]^T = I v.
Eigen::Matrix<double, 3, 6> inertiaTimes(const Vector3d& v) {
  Eigen::Matrix<double, 3, 6> L;
  L << v.x(), v.y(), v.z(), 0, 0, 0,  //
      0, v.x(), 0, v.y(), v.z(), 0,   //
      0, 0, v.x(), 0, v.y(), v.z();
  return L;
}

}  // namespace

Regressor regressor(const WrenchState& state) {
  const Matrix3d W = skew(state.omega);
  Regressor Y = Regressor::Zero();
  Y.block<3, 1>(0, 0) = state.specificForce;
  Y.block<3, 3>(0, 1) = skew(state.alpha) + W * W;
  Y.block<3, 3>(3, 1) = -skew(state.specificForce);
  Y.block<3, 6>(3, 4) = inertiaTimes(state.alpha) + W * inertiaTimes(state.omega);
  return Y;
}

Vector6d predictWrench(const Payload& payload, const WrenchState& state) {
  // Specific force at the centre of mass carries the mass; the rest turns the body about it.
  const Vector3d& c = payload.com;
  const Vector3d& w = state.omega;
  const Vector3d f = payload.mass * (state.specificForce + state.alpha.cross(c) + w.cross(w.cross(c)));
  const Matrix3d& I = payload.inertiaCom;
  Vector6d F;
  F << f, I * state.alpha + w.cross(I * w) + c.cross(f);
  return F;
}

}  // namespace heft
