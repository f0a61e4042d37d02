#include "core/compensation/entry_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/base/say.h"
#include "core/estimation/uncertainty.h"
#include "core/exporters/flange.h"
#include "core/math/linear_algebra.h"
#include "core/wrench/regressor.h"

namespace heft {
namespace {

/// Chi-squared with 4 and with 6 degrees of freedom that a right entry exceeds once in 40: both together once in 20.
constexpr double kMassCentreByChance = 11.143, kInertiaByChance = 14.449;
/// Of the motion for which a phantom stays below what is told: single samples of noisy joints do not count.
constexpr double kMostOfTheMotion = 0.99;

/// The index of the instant below which kMostOfTheMotion of all lie.
Eigen::Index nearlyLargest(const VectorXd& sizes) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(sizes.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto at = order.begin() + static_cast<std::ptrdiff_t>(kMostOfTheMotion * static_cast<double>(sizes.size() - 1));
  std::nth_element(order.begin(), at, order.end(), [&](Eigen::Index a, Eigen::Index b) { return sizes(a) < sizes(b); });
  return *at;
}

/// Sum of squares in standard deviations; infinite where something without any is off.
double squaresOf(const Vector10d& off, const Vector10d& std, int first, int count) {
  double sum = 0.0;
  for (int i = first; i < first + count; ++i)
    if (off(i) != 0.0) sum += std(i) > 0.0 ? std::pow(off(i) / std(i), 2) : std::numeric_limits<double>::infinity();
  return sum;
}

Payload completed(const PartialPayload& told, const Payload& actual) {
  if (*told.mass == 0.0) return {};
  return {*told.mass, told.com.value_or(actual.com), told.inertiaCom.value_or(actual.inertiaCom)};
}

/// From a wrench about S's origin in S axes to one about F's origin in F axes.
Matrix6d toFlangeAxes(const Isometry3d& X_FS) {
  Matrix6d out = Matrix6d::Zero();
  out.topLeftCorner<3, 3>() = out.bottomRightCorner<3, 3>() = X_FS.linear();
  out.bottomLeftCorner<3, 3>() = skew(X_FS.translation()) * X_FS.linear();
  return out;
}

}  // namespace

Result<EntryCost> costOfEntry(const PartialPayload& told, const EstimateReport& report,
                              const std::vector<Payload>& mounted, const ControllerLimits& limits,
                              const Recording& recording, const RobotModel* robot) {
  if (!told.mass || !(*told.mass >= 0.0))
    return Error{heft::say("What the controller is set to needs a mass of zero or more.")};
  FlangeOptions options;
  options.add = mounted;
  auto placed = toFlange(toJson(report), report.file, options);
  if (!placed) return placed.error();
  const bool poses = recording.meta.kind == RecordingKind::poses;
  const auto motion = poses ? standingPoses(recording, robot) : motionOf(recording, robot, MotionOptions{});
  if (!motion) return motion.error();

  EntryCost out;
  out.actual = placed->input.payload;
  out.told = completed(told, out.actual);
  out.centreTold = told.com.has_value() || *told.mass == 0.0;
  out.inertiaTold = told.inertiaCom.has_value() || *told.mass == 0.0;
  out.X_FS = placed->X_FS;
  for (auto& finding : placed->findings)
    if (finding.code == "flange_assumed" || finding.code == "mount_unknown") out.findings.push_back(std::move(finding));

  const Isometry3d X_SF = out.X_FS.inverse();
  const Vector10d estimated = toParameters(report.payload);
  const Vector10d more = toParameters(transformed(out.actual, X_SF)) - toParameters(transformed(out.told, X_SF));
  const Matrix10d J = componentsJacobian(estimated);
  const Vector10d std = componentsOf(report.std), off = J * more;
  out.differs = squaresOf(off, std, 0, 4) > kMassCentreByChance ||
                (out.inertiaTold && squaresOf(off, std, 4, 6) > kInertiaByChance);
  // Of phi, taking the numbers of files as independent of each other.
  const Matrix10d spread = pseudoInverse(J) * std.asDiagonal();

  const Matrix6d toF = toFlangeAxes(out.X_FS);
  const auto Y = [&](Eigen::Index k) -> Regressor {
    return toF * regressor({motion->specificForce.col(k), motion->omega.col(k), motion->alpha.col(k)});
  };
  out.time.resize(motion->size());
  out.phantom.resize(6, motion->size());
  for (Eigen::Index k = 0; k < motion->size(); ++k) {
    out.time(k) = poses ? recording.time(k) : motion->time(k);
    out.phantom.col(k) = -Y(k) * more;  // The tool pulls at the flange; the flange holds the tool.
  }
  const auto size = [&](int first, double& largest, double& deviation) {
    const VectorXd sizes = out.phantom.middleRows<3>(first).colwise().norm().transpose();
    const Eigen::Index k = nearlyLargest(sizes);
    largest = sizes(k);
    const Eigen::Matrix<double, 3, 10> spreadHere = (Y(k) * spread).middleRows<3>(first);
    // Along the phantom; with none, in the direction that is known least.
    deviation = largest > 0.0 ? (out.phantom.col(k).segment<3>(first).transpose() / largest * spreadHere).norm()
                              : spreadHere.rowwise().norm().maxCoeff();
  };
  size(0, out.force, out.forceStd);
  size(3, out.torque, out.torqueStd);
  out.weight = (out.actual.mass - out.told.mass) * recording.meta.gravity.norm();
  out.forceShare = out.force / limits.collisionForce;
  out.torqueShare = out.torque / limits.collisionTorque;
  out.sag = out.weight / limits.stiffness;
  return out;
}

}  // namespace heft
