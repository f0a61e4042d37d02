#include "core/estimation/carried_object.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/estimation/estimate_prepared.h"
#include "core/estimation/judgement.h"
#include "core/estimation/prior.h"
#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

/// Chi-squared of mass and first moments, 4 degrees of freedom, that one object in a hundred that is not there exceeds.
constexpr double kSeen = 13.277;

/// Rows of a triangle that know the payload, biases eliminated: [A | y].
MatrixXd payloadRows(const Triangle& R, bool bias) {
  const int first = bias ? kBiasColumns : 0;
  return R.block(first, kBiasColumns, kColumns + 1 - first, 11);
}

Result<Triangle> toolPrior(const EstimateOptions& options, const Triangle& R) {
  Findings ignored;
  auto prior = priorFor(options, R, ignored);
  if (!prior) return prior.error();
  return priorRows(prior->prior, solveMap(R, prior->prior, options.bias, prior->start).v);
}

/// The rows of both recordings with the tool eliminated: [tool; object] explain `with`, the tool alone `without`.
Triangle objectTriangle(const Triangle& with, const Triangle& without, const Triangle& tool, bool bias) {
  const MatrixXd a = payloadRows(with, bias), b = payloadRows(without, bias), c = payloadRows(tool, bias);
  MatrixXd stacked = MatrixXd::Zero(a.rows() + b.rows() + c.rows(), 21);
  stacked.topLeftCorner(a.rows(), 10) = a.leftCols<10>();
  stacked.block(0, 10, a.rows(), 11) = a;
  stacked.block(a.rows(), 0, b.rows(), 10) = b.leftCols<10>();
  stacked.block(a.rows(), 20, b.rows(), 1) = b.col(10);
  stacked.bottomLeftCorner(c.rows(), 10) = c.leftCols<10>();
  stacked.bottomRightCorner(c.rows(), 1) = c.col(10);
  Triangle R = Triangle::Zero();
  R.bottomRightCorner<11, 11>() = upperTriangle(stacked).bottomRightCorner<11, 11>();
  return R;
}

/// Both wrenches must be in the same axes about the same point.
std::string mountsDiffer(const Recording& with, const Recording& without) {
  const SensorMount &a = with.meta.mount, &b = without.meta.mount;
  constexpr double kLength = 1e-6, kAngle = 1e-6;  // [m], [rad]: what writing a file rounds away
  const std::string from = printable(with.file, 200), to = printable(without.file, 200);
  if (a.parent != b.parent)
    return heft::say("The sensor is mounted on {} in {} and on {} in {}.", printable(a.parent), from,
                     printable(b.parent), to);
  if ((a.xyz - b.xyz).norm() > kLength)
    return heft::say("The sensor position differs by {:.2f} mm between {} and {}.", 1e3 * (a.xyz - b.xyz).norm(), from,
                     to);
  const Matrix3d turn = rotationFromRpy(a.rpy).transpose() * rotationFromRpy(b.rpy);
  const double angle = Eigen::AngleAxisd(turn).angle();
  if (angle > kAngle)
    return heft::say("The sensor is turned by {:.2f} degrees between {} and {}.", angle * 180.0 / std::numbers::pi,
                     from, to);
  return "";
}

void comparePair(const Recording& with, const Recording& without, Findings& findings) {
  const auto warn = [&](const char* code, std::string text, std::string remedy) {
    findings.push_back({Severity::warning, code, std::move(text), std::move(remedy), {}});
  };
  if (with.meta.sensorModel != without.meta.sensorModel)
    warn("different_sensors",
         heft::say("The two recordings name different sensors: \"{}\" and \"{}\".", printable(with.meta.sensorModel),
                   printable(without.meta.sensorModel)),
         heft::say("Use recordings of the same sensor: another one has other axes and another gain."));
  const double a = with.meta.gravity.norm(), b = without.meta.gravity.norm();
  if (std::abs(a - b) > 0.005 * std::max(a, b))
    warn("different_gravity", heft::say("The two recordings state different gravity: {:.3f} and {:.3f} m/s2.", a, b),
         heft::say("State the same \"gravity_m_s2\" in both setup files."));
}

ObjectVerdict verdictOf(const CarriedObject& c) {
  const Eigen::Vector4d moments = c.difference.head<4>();
  const Matrix4d S = c.covariance.topLeftCorner<4, 4>();
  if (moments.dot(solveSymmetric(S, moments)) < kSeen) return ObjectVerdict::nothing;
  const double sigma = std::sqrt(c.covariance(0, 0));
  if (c.difference(0) < -2.0 * sigma) return ObjectVerdict::negative;
  return c.difference(0) > 2.0 * sigma ? ObjectVerdict::found : ObjectVerdict::nothing;
}

/// The worse trust of the two, and why.
void takeTrust(const EstimateReport& report, const char* code, EstimateReport& object) {
  const std::string file = printable(report.file, 200);
  if (report.trust == Trust::none) {
    loseTrust(object, {file + ": " + report.whyNoTrust, report.whatToDo});
  } else if (report.trust == Trust::low && object.trust == Trust::good) {
    object.trust = Trust::low;
    object.findings.push_back({Severity::warning,
                               code,
                               heft::say("{} is not reliable, so neither are the object's numbers.", file),
                               heft::say("Estimate it separately and look at its findings."),
                               {}});
  }
}

/// Only the mass, from the data alone.
void reportMassOnly(CarriedObject& out) {
  EstimateReport& object = out.object;
  object.payload = {out.difference(0), Vector3d::Zero(), Matrix3d::Zero()};
  Matrix10d covariance = Matrix10d::Zero();
  covariance(0, 0) = out.covariance(0, 0);
  object.interval95 = intervalsFromCovariance(componentsOf(object.payload), covariance);
  object.std = standardDeviations(object.interval95);
}

std::optional<Error> solveObject(const Triangle& R, CarriedObject& out) {
  EstimateReport& object = out.object;
  EstimateOptions plain;
  plain.bias = false;  // they are eliminated
  auto prior = priorFor(plain, R, object.findings);
  if (!prior) return prior.error();
  const MapSolution map = solveMap(R, prior->prior, false, prior->start);
  object.payload = fromParameters(map.phi);
  object.interval95 = intervalsFromV(R, prior->prior, false, map);
  object.std = standardDeviations(object.interval95);
  object.physicallyConsistent = checkPhysical(object.payload).physical;
  object.identifiability = assess(R, prior->prior, map, object.std, prior->told);
  object.evidence = evidenceOf(R, false, map.phi, prior->alone, prior->told);
  return std::nullopt;
}

}  // namespace

std::string_view toString(ObjectVerdict verdict) {
  switch (verdict) {
    case ObjectVerdict::found:
      return "found";
    case ObjectVerdict::nothing:
      return "nothing";
    case ObjectVerdict::negative:
      return "negative";
  }
  return "nothing";
}

Result<CarriedObject> estimateCarriedObject(const JointInput& with, const JointInput& without,
                                            const EstimateOptions& options, const ReadingFindings& read,
                                            const Progress& progress) {
  if (options.method != Method::map || options.parameters != ParameterSet::full || options.shape ||
      !options.stated.empty())
    return Error{heft::say(
        "The object is found by the method map with all parameters and without a shape or a stated mass, which would "
        "be that of one of the two bodies.")};
  if (const std::string why = mountsDiffer(*with.recording, *without.recording); !why.empty())
    return Error{why + " " +
                 heft::say("The object is the difference of two estimates in the same sensor axes: state the same "
                           "\"mount\" in both setup files, or record both with the same one.")};
  CarriedObject out;
  std::array<Triangle, 2> whitened;
  for (int i = 0; i < 2; ++i) {
    const JointInput& input = i == 0 ? with : without;
    const auto prepared = prepareFor(*input.recording, input.robot, options, progress);
    if (!prepared)
      return Error{printable(input.recording->file, 200) + ": " + prepared.error().message, prepared.error().cancelled};
    auto report = estimatePrepared(*input.recording, *prepared, options, {}, 0.0, progress);
    if (!report) return report.error();
    addReadingFindings(i == 0 ? read.with : read.without, *report);
    whitened[static_cast<std::size_t>(i)] = prepared->whitened;
    (i == 0 ? out.with : out.without) = std::move(*report);
  }
  const auto tool = toolPrior(options, whitened[1]);
  if (!tool) return tool.error();
  const Triangle R = objectTriangle(whitened[0], whitened[1], *tool, options.bias);
  const PlainFit data = plainFit(R, true);
  out.difference = data.phi;
  out.covariance = data.covariance;
  out.verdict = verdictOf(out);
  EstimateReport& object = out.object;
  object.parameters = ParameterSet::full;
  comparePair(*with.recording, *without.recording, object.findings);
  if (!object.findings.empty()) object.trust = Trust::low;
  if (out.verdict == ObjectVerdict::found) {
    if (auto failed = solveObject(R, out)) return *failed;
  } else {
    reportMassOnly(out);
  }
  takeTrust(out.with, "low_trust_with", object);
  takeTrust(out.without, "low_trust_without", object);
  doubtLabels(object);
  if (out.verdict == ObjectVerdict::negative && object.trust != Trust::none)
    loseTrust(object, {heft::say("The tool is {:.3f} kg lighter with the object than without it.", -out.difference(0)),
                       heft::say("Swap the two recordings, or check that both are of the same tool.")});
  return out;
}

}  // namespace heft
