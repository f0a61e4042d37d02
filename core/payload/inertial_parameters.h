#pragma once
// The ten inertial parameters of a payload and what makes them physically possible.
//
// Order and reference, stated once: phi = [m, hx, hy, hz, Ixx, Ixy, Ixz, Iyy, Iyz, Izz] with h = m p_SPcm_S [kg m] and
// I = I_PSo_S, the rotational inertia about S's ORIGIN [kg m2], all in S axes. In this form the wrench is linear in
// phi. Payload holds what files hold: mass, centre of mass from S's origin, inertia about the CENTRE OF MASS, S axes.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/math/rigid.h"

namespace heft {

struct Payload {
  double mass = 0.0;                       ///< [kg]
  Vector3d com = Vector3d::Zero();         ///< p_SPcm_S [m]
  Matrix3d inertiaCom = Matrix3d::Zero();  ///< I_PPcm_S [kg m2], tensor sign convention (Ixy = -integral x y dm)
};

/// Values that the user states: any part may be absent.
struct PartialPayload {
  std::optional<double> mass;
  std::optional<Vector3d> com;
  std::optional<Matrix3d> inertiaCom;
  bool empty() const { return !mass && !com && !inertiaCom; }
};

/// I about S's origin from I about the centre of mass (parallel axes), and back.
Matrix3d inertiaAboutOrigin(const Payload& payload);

Vector10d toParameters(const Payload& payload);

/// Inverse of toParameters. With mass 0 the centre of mass is undefined and left at zero.
Payload fromParameters(const Vector10d& phi);

/// I_PSo_S from the last six parameters.
Matrix3d inertiaTensor(const Vector10d& phi);

/// Pseudo-inertia P = [Sigma h; h^T m], Sigma = tr(I)/2 - I about S's origin (Wensing 2017, arXiv 1701.04395):
/// a payload can exist exactly if P is positive definite.
Matrix4d pseudoInertia(const Vector10d& phi);
Vector10d parametersFromPseudoInertia(const Matrix4d& P);

struct Consistency {
  bool physical = false;
  std::string reason;  ///< Empty if physical; otherwise one sentence with the numbers.
};

/// Positive mass, positive definite inertia about the centre of mass, and principal moments that satisfy the triangle
/// inequality, each to a relative tolerance of 1e-9 (a flat plate passes). NaN and infinities fail.
Consistency checkPhysical(const Payload& payload);

/// The same payload expressed in frame N, given X_NS: com' = X_NS * com, I' = R I R^T.
Payload transformed(const Payload& payload, const Isometry3d& X_NS);

/// Both bodies as one; both in the same frame.
Payload composed(const Payload& a, const Payload& b);

/// JSON object with the keys mass_kg, com_m, inertia_com_kgm2 of the contract.
nlohmann::json toJson(const Payload& payload);

/// Reads mass_kg, com_m, inertia_com_kgm2 (each optional) from an object, or from its member "payload" or
/// "known_payload". `where` names the file in messages. Fails on wrong shapes, non-finite or asymmetric tensors,
/// negative mass.
Result<PartialPayload> partialPayloadFromJson(const nlohmann::json& object, const std::string& where);

/// As above, but all three must be there.
Result<Payload> payloadFromJson(const nlohmann::json& object, const std::string& where);

}  // namespace heft
