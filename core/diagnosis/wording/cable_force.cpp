#include "core/diagnosis/wording/cable_force.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/diagnosis/calibration.h"

namespace heft::diagnosis {

namespace {

constexpr double kMetre = 1e-3;  ///< Places and lengths are told in mm

/// 3 x N; empty if one of them is missing.
Eigen::Matrix3Xd positions(const std::vector<Witness>& witnesses) {
  std::array<const VectorXd*, 3> axes{};
  for (const Witness& w : witnesses)
    for (std::size_t i = 0; i < 3; ++i)
      if (w.id == std::string("position_") + "xyz"[i]) axes[i] = &w.value;
  if (std::ranges::any_of(axes, [](const VectorXd* axis) { return !axis || axis->size() == 0; })) return {};
  Eigen::Matrix3Xd out(3, axes[0]->size());
  for (Eigen::Index i = 0; i < 3; ++i) out.row(i) = axes[static_cast<std::size_t>(i)]->transpose();
  return out;
}

}  // namespace

std::optional<Pull> pullOf(const DiagnosedCause& cable, const std::vector<Witness>& witnesses) {
  const Eigen::Matrix3Xd tool = positions(witnesses);
  if (tool.cols() == 0) return std::nullopt;
  const Matrix3d stiffness = tensorOf("stiffness", cable.parameters);
  const CauseParameter* alike = findParameter(cable.parameters, "stiffness");
  const CauseParameter* slack = findParameter(cable.parameters, "length");
  Vector3d stiffnessStd = Vector3d::Zero(), force = Vector3d::Zero(), forceStd = Vector3d::Zero();
  Pull out;
  bool placed = false;
  for (int i = 0; i < 3; ++i) {
    const char axis = "xyz"[i];
    const CauseParameter* along = findParameter(cable.parameters, std::string("stiffness_") + axis);
    if (const CauseParameter* told = along ? along : alike) stiffnessStd(i) = told->std;
    if (const CauseParameter* f = findParameter(cable.parameters, std::string("force_") + axis))
      force(i) = f->value, forceStd(i) = f->std;
    if (const CauseParameter* anchor = findParameter(cable.parameters, std::string("anchor_") + axis)) {
      placed = true;
      out.anchor(i) = kMetre * anchor->value;
      out.anchorStd = std::max(out.anchorStd, kMetre * anchor->std);
    }
    if (!(stiffness(i, i) > 0.0) || stiffness(i, i) < kDeviations * stiffnessStd(i)) return std::nullopt;
  }
  const Eigen::LLT<Matrix3d> solver(stiffness);
  if (solver.info() != Eigen::Success) return std::nullopt;
  if (!placed) {
    const Vector3d away = solver.solve(force);
    out.anchor = tool.rowwise().mean() + away;
    for (int i = 0; i < 3; ++i)
      out.anchorStd = std::max(out.anchorStd, std::hypot(forceStd(i), away(i) * stiffnessStd(i)) / stiffness(i, i));
  }
  const CauseParameter* grows = findParameter(cable.parameters, "hardening");
  const double length = slack ? kMetre * slack->value : 0.0, hardening = grows ? grows->value : 0.0;
  for (Eigen::Index n = 0; n < tool.cols(); ++n) {
    const Vector3d way = tool.col(n) - out.anchor;
    const double far = way.norm();
    if (far <= length) continue;
    const double stretched = far - length, more = hardening * stretched * stretched * stretched;
    out.force += ((stretched / far * (stiffness * way)).norm() + more) / static_cast<double>(tool.cols());
  }
  return out;
}

}  // namespace heft::diagnosis
