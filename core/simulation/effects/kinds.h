#pragma once
// The kinds by where they act, and drawing that they share.
#include "core/simulation/effects/effect.h"

namespace heft {

void addGeometryKinds(std::vector<EffectKind>& kinds);
void addPullKinds(std::vector<EffectKind>& kinds);
void addDragKinds(std::vector<EffectKind>& kinds);
void addMassKinds(std::vector<EffectKind>& kinds);
void addContactKinds(std::vector<EffectKind>& kinds);
void addGaugeKinds(std::vector<EffectKind>& kinds);
void addTransportKinds(std::vector<EffectKind>& kinds);
void addZeroKinds(std::vector<EffectKind>& kinds);
void addConverterKinds(std::vector<EffectKind>& kinds);
void addVelocityKinds(std::vector<EffectKind>& kinds);
void addRowKinds(std::vector<EffectKind>& kinds);
void addFrameKinds(std::vector<EffectKind>& kinds);

template <class T>
std::function<std::unique_ptr<Effect>(const EffectSetup&)> making() {
  return [](const EffectSetup& setup) { return std::make_unique<T>(setup); };
}

/// Uniform on the sphere.
Vector3d drawDirection(RandomStream& random);
/// Within about 30 degrees of horizontal.
Vector3d drawSideways(RandomStream& random, const Vector3d& gravity);
/// p_SoP_S near the payload's centre of mass.
Vector3d drawToolPoint(RandomStream& random, const Payload& payload, double reach);

/// What the sensor must exert on the payload against a force `F_B` [N] in base axes that the world exerts at p_SoP_S.
Vector6d against(const Instant& now, const Vector3d& F_B, const Vector3d& p_SoP_S);

/// Position and velocity of the point p_SoP_S of the tool, base axes.
Vector3d pointPosition(const FrameMotion& motion, const Vector3d& p_SoP_S);
Vector3d pointVelocity(const FrameMotion& motion, const Vector3d& p_SoP_S);

/// Middle of the tool's positions on the path [m].
Vector3d middleOf(const EffectScene& scene);

/// A torque [N m] that goes with a force [N] in a wrist sensor: the length of a hand tool.
constexpr double kTorqueArm = 0.02;  // [m]

}  // namespace heft
