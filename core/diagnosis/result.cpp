#include "core/diagnosis/result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/search/evidence.h"

namespace heft {

using nlohmann::json;

std::string_view toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::clean:
      return "clean";
    case Verdict::explained:
      return "explained";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unexplained:
      return "unexplained";
  }
  return "";
}

bool mountIsWrong(const DiagnosedCause& cause) {
  return diagnosis::infoOf(cause.id).placesSensor || (cause.ofMistake && !cause.parameters.empty());
}

nlohmann::json DiagnosisReport::metaChanges() const {
  json out = json::object();
  // Of two readings that fit alike a person has to choose.
  if (mistake && !mistake->positionsKept && !mistake->tied)
    if (json patch = conventions::metaPatch(mistake->stated, mistake->reading, meta.mount, !ofPoses); patch.is_object())
      out = std::move(patch);
  for (const auto& cause : causes) {
    if (ofPoses || !mountIsWrong(cause) || cause.direct) continue;
    const auto vectorOf = [&](std::array<std::string_view, 3> names) {
      Vector3d v = Vector3d::Zero();
      for (std::size_t i = 0; i < names.size(); ++i)
        if (const auto* p = findParameter(cause.parameters, names[i])) v(static_cast<Eigen::Index>(i)) = p->value;
      return v;
    };
    constexpr double kRad = 3.14159265358979323846 / 180.0;
    const Matrix3d R = rotationFromRpy(meta.mount.rpy);
    if (cause.id == diagnosis::ids::leverArm) {
      const Vector3d xyz = meta.mount.xyz + R * vectorOf({"dx", "dy", "dz"}) * 1e-3;
      out["sensor"]["mount"]["xyz_m"] = {xyz.x(), xyz.y(), xyz.z()};
    } else {
      const Vector3d rpy = rpyFromRotation(R * rotationFromVector(vectorOf({"rx", "ry", "rz"}) * kRad));
      out["sensor"]["mount"]["rpy_rad"] = {rpy.x(), rpy.y(), rpy.z()};
    }
  }
  for (const auto& term : model.terms) {
    if (term.form->cause->id() != diagnosis::ids::gravityTilt) continue;
    diagnosis::Signals one;
    one.gravity = mistake ? mistake->reading.gravity : meta.gravity;
    one.R_BS = {Matrix3d::Identity()};
    one.kinematics.specificForce = -one.gravity;
    diagnosis::Kinematics bent = one.kinematics;
    bent.omega = bent.alpha = Eigen::Matrix3Xd::Zero(3, 1);
    one.kinematics.omega = one.kinematics.alpha = bent.omega;
    term.form->cause->geometry(*term.form, term.v, one, bent);
    const Vector3d g = -bent.specificForce.col(0);
    out["gravity_m_s2"] = {g.x(), g.y(), g.z()};
  }
  return out;
}

bool DiagnosisReport::Check::holds() const { return gain > diagnosis::kThreshold || setsRight; }

}  // namespace heft
