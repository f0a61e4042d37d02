#include "core/compensation/proof.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/doubts.h"
#include "core/base/say.h"
#include "core/compensation/payload_difference.h"
#include "core/estimation/estimate_prepared.h"
#include "core/estimation/judgement.h"
#include "core/exporters/controller_file.h"
#include "core/exporters/flange.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

/// So many deviations off is beyond the limit in 87 of 100 cases (non-central chi-squared, 4 degrees of freedom, 25).
constexpr double kSeenAt = 5.0;
/// A proof that would let these pass proves nothing.
constexpr double kMassWorth = 0.05;     // relative
constexpr double kCentreWorth = 0.005;  // [m]
/// What the best payload leaves, over the sensor's scatter, that a misfit must reach to be more than noise beside a
/// motion that makes next to no load (as core/estimation/judgement.cpp has it for slow residuals).
constexpr double kBeyondNoise = 1.3;

void compareNumbers(const Triangle& R, bool bias, Proof& proof) {
  const Payload& p = proof.entered.payload;
  const Vector10d phi = toParameters(p);
  const PlainFit rows = plainFit(R, bias);
  // All in the numbers of files, linear about the entered payload.
  const Matrix10d J = componentsJacobian(phi);
  Matrix10d covariance = congruence(J, rows.covariance);
  covariance.diagonal() += componentsOf(proof.entered.std).cwiseAbs2();
  const PayloadDifference difference = payloadDifference(J * (phi - rows.phi), covariance, p);
  proof.off = difference.off;
  proof.offStd = difference.std;
  proof.massCentreChi2 = difference.massCentreChi2;
  proof.inertiaChi2 = difference.inertiaChi2;
  proof.massCentreDiffers = difference.massCentreDiffers();
  proof.inertiaDiffers = difference.inertiaDiffers();
  proof.smallestMass = kSeenAt * proof.offStd(0);
  proof.smallestCentre = kSeenAt * proof.offStd.segment<3>(1).maxCoeff();
  if (bias)
    proof.bias =
        solveUpper(R.topLeftCorner<6, 6>(), R.block<6, 1>(0, kColumns) - R.block<6, 10>(0, kBiasColumns) * phi);
}

void notYet(Proof& proof, const char* code, std::string text, std::string next) {
  proof.verdict = ProofVerdict::notYet;
  proof.reasons.push_back({Severity::warning, code, std::move(text), std::move(next), {}});
}

void judgeNumbers(Proof& proof) {
  const auto over = [&](int i) { return std::abs(proof.off(i)) / proof.offStd(i); };
  if (proof.massCentreDiffers) {
    const double centre = std::max({over(1), over(2), over(3)});
    if (over(0) >= centre)
      notYet(proof, "other_mass",
             heft::say("The entered mass of {:.3f} kg is off by {:+.3f} kg; noise and intervals allow {:.3f} kg.",
                       proof.entered.payload.mass, proof.off(0), 2.0 * proof.offStd(0)),
             heft::say("Check which tool is mounted and that the number was entered in kg, or estimate it again."));
    else
      notYet(proof, "other_centre",
             heft::say("The entered centre of mass is off by {:+.1f}, {:+.1f}, {:+.1f} mm along x, y, z; noise and "
                       "intervals allow {:.1f} mm.",
                       1e3 * proof.off(1), 1e3 * proof.off(2), 1e3 * proof.off(3),
                       2e3 * proof.offStd.segment<3>(1).maxCoeff()),
             heft::say("Check that the numbers are in sensor axes and metres, or estimate it again."));
  }
  if (proof.inertiaDiffers)
    notYet(proof, "other_inertia", heft::say("The entered inertia does not match the torques during rotation."),
           heft::say("Check its unit and that it is about the centre of mass, or estimate it again."));
}

bool motionCanTell(const Proof& proof) {
  return proof.smallestMass <= kMassWorth * proof.entered.payload.mass && proof.smallestCentre <= kCentreWorth;
}

void sayWhyItCannotTell(Proof& proof) {
  proof.verdict = ProofVerdict::cannotTell;
  const double mass = proof.entered.payload.mass;
  const Vector10d own = componentsOf(proof.entered.std);
  const bool wide = kSeenAt * own(0) > kMassWorth * mass || kSeenAt * own.segment<3>(1).maxCoeff() > kCentreWorth;
  proof.reasons.push_back(
      {Severity::warning,
       "cannot_tell",
       proof.smallestMass < mass ? heft::say("An error of {:.3f} kg or {:.1f} mm would go unnoticed in this recording.",
                                             proof.smallestMass, 1e3 * proof.smallestCentre)
                                 : heft::say("Neither mass nor centre of mass can be checked with this recording."),
       wide ? heft::say("The payload's own interval is too wide: estimate it from a better motion first.")
            : heft::say("Guide the tool for ten seconds and tilt it in all directions without touching anything."),
       {}});
}

/// Whether the best payload leaves more than noise.
bool leavesMoreThanNoise(const Prepared& prepared, const Proof& proof) {
  Vector6d bias;
  bias << proof.own.forceBias, proof.own.torqueBias;
  const SolverSolution best{toParameters(proof.own.payload), bias, true, 0, ""};
  const Vector6d left = residualsOver(prepared, [&](Eigen::Index) -> const SolverSolution& { return best; }).channels;
  return (left.array() > kBeyondNoise * proof.noise.array()).any();
}

/// A controller's file, from flange axes to those of the sensor.
Result<Payload> inSensorAxes(const nlohmann::json& object, const std::string& where, const SensorMount& mount) {
  auto payload = controllerPayloadFromJson(object, where);
  if (!payload) return payload;
  FlangeOptions options;
  options.mount = mount;
  const auto placed = toFlange(toJson(*payload), where, options);
  if (!placed) return placed.error();
  return transformed(*payload, placed->X_FS.inverse());
}

}  // namespace

std::string_view toString(ProofVerdict verdict) {
  switch (verdict) {
    case ProofVerdict::pass:
      return "pass";
    case ProofVerdict::notYet:
      return "not_yet";
    case ProofVerdict::cannotTell:
      break;
  }
  return "cannot_tell";
}

Result<EnteredPayload> enteredPayloadFromJson(const nlohmann::json& object, const std::string& where,
                                              const SensorMount& mount) {
  auto payload = isControllerFile(object) ? inSensorAxes(object, where, mount) : payloadFromJson(object, where);
  if (!payload) return payload.error();
  EnteredPayload out{*payload, {0.0, Vector3d::Zero(), Matrix3d::Zero()}, Trust::good, where};
  if (!(out.payload.mass > 0.0)) return Error{heft::say("{}: the mass must be above zero.", where)};
  if (!object.is_object()) return out;
  if (const auto trust = object.find("trust"); trust != object.end())
    for (const Trust value : {Trust::low, Trust::none})
      if (*trust == toString(value)) out.trust = value;
  if (const auto std = object.find("std"); std != object.end()) {
    auto parts = partialPayloadFromJson(*std, where);
    if (!parts) return parts.error();
    out.std = {parts->mass.value_or(0.0), parts->com.value_or(Vector3d::Zero()),
               parts->inertiaCom.value_or(Matrix3d::Zero())};
  }
  return out;
}

Result<Proof> prove(const EnteredPayload& entered, const Recording& recording, const RobotModel* robot,
                    const EstimateOptions& options, const Findings& read, const Progress& progress) {
  if (options.method != Method::map || options.parameters != ParameterSet::full || options.shape)
    return Error{heft::say("A proof compares with what the motion alone shows: method map, all parameters, no shape.")};
  const auto prepared = prepareFor(recording, robot, options, progress);
  if (!prepared) return prepared.error();
  auto own = estimatePrepared(recording, *prepared, options, {}, 0.0, progress);
  if (!own) return own.error();
  addReadingFindings(read, *own);
  Proof proof;
  proof.entered = entered;
  proof.own = std::move(*own);
  proof.verdict = ProofVerdict::pass;
  compareNumbers(prepared->whitened, options.bias, proof);
  const SolverSolution taken{toParameters(entered.payload), proof.bias, true, 0, ""};
  proof.left = residualsOver(*prepared, [&](Eigen::Index) -> const SolverSolution& { return taken; }).channels;
  proof.noise = proof.own.noiseStd;

  if (entered.trust == Trust::none)
    notYet(proof, "payload_not_trusted", heft::say("{} marks its own numbers as not trustworthy.", entered.file),
           heft::say("Estimate the payload again, and look at its findings."));
  if (proof.own.trust == Trust::none) {
    notYet(proof, "no_trust", proof.own.whyNoTrust, proof.own.whatToDo);
    return proof;
  }
  const bool fits = !proof.massCentreDiffers && !proof.inertiaDiffers;
  const bool misfit =
      leavesMoreThanNoise(*prepared, proof) && std::ranges::count(proof.own.findings, "misfit", &Finding::code) > 0;
  if (fits && !misfit && !motionCanTell(proof)) {
    sayWhyItCannotTell(proof);
    return proof;
  }
  // With something else at work nobody can say what is the payload's.
  for (const auto& finding : proof.own.findings)
    if (doubtsNumbers(finding.severity, finding.code) && (misfit || finding.code != "misfit"))
      notYet(proof, finding.code.c_str(), finding.text,
             heft::say("Find the cause first, for instance with a diagnosis."));
  judgeNumbers(proof);
  return proof;
}

}  // namespace heft
