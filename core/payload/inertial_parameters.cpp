#include "core/payload/inertial_parameters.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/say.h"

namespace heft {

using nlohmann::json;

Matrix3d inertiaAboutOrigin(const Payload& payload) {
  const Vector3d& c = payload.com;
  return payload.inertiaCom + payload.mass * (c.squaredNorm() * Matrix3d::Identity() - c * c.transpose());
}

Vector10d toParameters(const Payload& payload) {
  const Matrix3d I = inertiaAboutOrigin(payload);
  Vector10d phi;
  phi << payload.mass, payload.mass * payload.com, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2);
  return phi;
}

Matrix3d inertiaTensor(const Vector10d& phi) {
  Matrix3d I;
  I << phi(4), phi(5), phi(6), phi(5), phi(7), phi(8), phi(6), phi(8), phi(9);
  return I;
}

Payload fromParameters(const Vector10d& phi) {
  Payload payload;
  payload.mass = phi(0);
  if (phi(0) != 0.0) payload.com = phi.segment<3>(1) / phi(0);
  const Vector3d& c = payload.com;
  payload.inertiaCom = inertiaTensor(phi) - payload.mass * (c.squaredNorm() * Matrix3d::Identity() - c * c.transpose());
  return payload;
}

Matrix4d pseudoInertia(const Vector10d& phi) {
  const Matrix3d I = inertiaTensor(phi);
  Matrix4d P;
  P.topLeftCorner<3, 3>() = 0.5 * I.trace() * Matrix3d::Identity() - I;
  P.topRightCorner<3, 1>() = phi.segment<3>(1);
  P.bottomLeftCorner<1, 3>() = phi.segment<3>(1).transpose();
  P(3, 3) = phi(0);
  return P;
}

Vector10d parametersFromPseudoInertia(const Matrix4d& P) {
  const Matrix3d sigma = P.topLeftCorner<3, 3>();
  const Matrix3d I = sigma.trace() * Matrix3d::Identity() - sigma;
  Vector10d phi;
  phi << P(3, 3), P.topRightCorner<3, 1>(), I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2);
  return phi;
}

Consistency checkPhysical(const Payload& payload) {
  if (!std::isfinite(payload.mass) || !payload.com.allFinite() || !payload.inertiaCom.allFinite())
    return {false, heft::say("A number is not finite.")};
  if (payload.mass <= 0.0) return {false, heft::say("The mass is {:.6g} kg; it must be above zero.", payload.mass)};
  const Matrix3d& I = payload.inertiaCom;
  const double scale = I.cwiseAbs().maxCoeff();
  if ((I - I.transpose()).cwiseAbs().maxCoeff() > 1e-9 * scale)
    return {false, heft::say("The inertia tensor is not symmetric.")};
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(I, Eigen::EigenvaluesOnly).eigenvalues();
  if (moments(0) <= 0.0)
    return {false, heft::say("The inertia tensor has a principal moment of {:.6g} kg m2; all must be above zero.",
                             moments(0))};
  if (moments(0) + moments(1) < moments(2) * (1.0 - 1e-9))
    return {false, heft::say("The principal moments {:.6g}, {:.6g}, {:.6g} kg m2 violate the triangle inequality: "
                             "no body has more about one axis than about the other two together.",
                             moments(0), moments(1), moments(2))};
  return {true, {}};
}

Payload transformed(const Payload& payload, const Isometry3d& X_NS) {
  const Matrix3d R = X_NS.linear();
  const Matrix3d I = R * payload.inertiaCom * R.transpose();
  return {payload.mass, X_NS * payload.com, 0.5 * (I + I.transpose())};
}

Payload composed(const Payload& a, const Payload& b) { return fromParameters(toParameters(a) + toParameters(b)); }

json toJson(const Payload& payload) {
  const auto row = [](const auto& v) { return json::array({v(0), v(1), v(2)}); };
  const Matrix3d& I = payload.inertiaCom;
  return {{"mass_kg", payload.mass},
          {"com_m", row(payload.com)},
          {"inertia_com_kgm2", json::array({row(I.row(0)), row(I.row(1)), row(I.row(2))})}};
}

namespace {

/// Reads `count` finite numbers; an empty message means success.
std::string readNumbers(const json& value, int count, double* out) {
  if (!value.is_array() || static_cast<int>(value.size()) != count)
    return heft::say("must be a list of {} numbers", count);
  for (int i = 0; i < count; ++i) {
    if (!value[i].is_number()) return heft::say("must be a list of {} numbers", count);
    out[i] = value[i].get<double>();
    if (!std::isfinite(out[i])) return heft::say("holds a number that is not finite");
  }
  return "";
}

}  // namespace

Result<PartialPayload> partialPayloadFromJson(const json& object, const std::string& where) {
  if (!object.is_object()) return Error{heft::say("{}: a payload must be a JSON object.", where)};
  for (const char* member : {"payload", "known_payload"})
    if (const auto it = object.find(member); it != object.end() && it->is_object())
      return partialPayloadFromJson(*it, where + ": " + member);

  PartialPayload payload;
  if (const auto it = object.find("mass_kg"); it != object.end() && !it->is_null()) {
    if (!it->is_number()) return Error{heft::say("{}: mass_kg must be a number in kilograms.", where)};
    const double mass = it->get<double>();
    if (!(std::isfinite(mass) && mass > 0.0))
      return Error{heft::say("{}: mass_kg is {}; a mass must be above zero.", where, mass)};
    payload.mass = mass;
  }
  if (const auto it = object.find("com_m"); it != object.end() && !it->is_null()) {
    Vector3d com;
    if (const auto problem = readNumbers(*it, 3, com.data()); !problem.empty())
      return Error{heft::say("{}: com_m {} in metres.", where, problem)};
    payload.com = com;
  }
  if (const auto it = object.find("inertia_com_kgm2"); it != object.end() && !it->is_null()) {
    Matrix3d I;
    if (!it->is_array() || it->size() != 3)
      return Error{heft::say("{}: inertia_com_kgm2 must be three rows of three numbers in kg m2.", where)};
    for (int r = 0; r < 3; ++r) {
      Vector3d row;
      if (const auto problem = readNumbers((*it)[r], 3, row.data()); !problem.empty())
        return Error{heft::say("{}: inertia_com_kgm2[{}] {} in kg m2.", where, r, problem)};
      I.row(r) = row.transpose();
    }
    if ((I - I.transpose()).cwiseAbs().maxCoeff() > 1e-6 * I.cwiseAbs().maxCoeff())
      return Error{heft::say("{}: inertia_com_kgm2 must be symmetric.", where)};
    payload.inertiaCom = 0.5 * (I + I.transpose());
  }
  return payload;
}

Result<Payload> payloadFromJson(const json& object, const std::string& where) {
  auto partial = partialPayloadFromJson(object, where);
  if (!partial) return partial.error();
  const auto missing = [&](const char* key) { return Error{heft::say("{}: {} is missing.", where, key)}; };
  if (!partial->mass) return missing("mass_kg");
  if (!partial->com) return missing("com_m");
  if (!partial->inertiaCom) return missing("inertia_com_kgm2");
  return Payload{*partial->mass, *partial->com, *partial->inertiaCom};
}

}  // namespace heft
