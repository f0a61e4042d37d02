#include "core/diagnosis/correction/re_estimate.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/correction/model_json.h"
#include "core/recording/frozen.h"

namespace heft::diagnosis {

namespace {

/// Variances of mass and centre.
struct Doubt {
  double mass = 0.0;
  Vector3d com = Vector3d::Zero();

  void add(const Vector10d& payload, const Vector10d& other, double weight) {
    const auto centre = [](const Vector10d& p) { return Vector3d(p.segment<3>(1) / std::max(0.02, std::abs(p(0)))); };
    mass += weight * std::pow(payload(0) - other(0), 2);
    com += weight * (centre(payload) - centre(other)).cwiseAbs2();
  }
};

/// As the joint fit of payload and causes has them.
Doubt ofFit(const Fit& fit) {
  Doubt out;
  const double m = std::max(0.02, std::abs(fit.model.x(6)));
  out.mass = fit.covariance(6, 6);
  for (int i = 0; i < 3; ++i) {
    const double c = fit.model.x(7 + i) / m;
    const double variance =
        fit.covariance(7 + i, 7 + i) - 2.0 * c * fit.covariance(6, 7 + i) + c * c * fit.covariance(6, 6);
    out.com(i) = std::max(0.0, variance) / (m * m);
  }
  return out;
}

/// What lies between the payloads of causes that tie.
Doubt ofTies(const DiagnosisReport& report, const Hypothesis& hypothesis) {
  Doubt out;
  const Vector10d payload = hypothesis.search.final.model.x.tail<10>();
  for (const Found& found : hypothesis.search.found) {
    const bool named = std::ranges::any_of(report.causes, [&](const DiagnosedCause& c) { return c.id == found.cause; });
    if (!named) continue;
    Doubt most;
    for (const Rival& rival : found.rivals) {
      Doubt one;
      one.add(payload, rival.payload, 1.0);
      most.mass = std::max(most.mass, one.mass);
      most.com = most.com.cwiseMax(one.com);
    }
    out.mass += most.mass;
    out.com += most.com;
  }
  return out;
}

/// What something unknown does to the payload of `fit`: a jackknife over ten parts of the recording.
Doubt ofUnknown(const Hypothesis& hypothesis, const Fit& fit) {
  Doubt out;
  const auto all = payloadsWithoutParts(hypothesis.signals, hypothesis.stretches, fit);
  const double n = static_cast<double>(all.cols());
  for (Eigen::Index i = 0; i < all.cols(); ++i) out.add(all.col(i), all.rowwise().mean(), (n - 1.0) / n);
  return out;
}

/// Deviations of mass and centre may not be smaller than `fit` has them, and there is `more`.
void widen(EstimateReport& report, const Doubt& fit, const Doubt& more) {
  const auto grow = [](double& deviation, Interval& interval, double least, double beside) {
    const double wide = std::sqrt(std::max(deviation * deviation, least) + beside);
    if (!(deviation > 0.0) || !(wide > deviation)) return;
    const double factor = wide / deviation, middle = 0.5 * (interval.lower + interval.upper);
    interval = {middle + factor * (interval.lower - middle), middle + factor * (interval.upper - middle)};
    deviation = wide;
  };
  grow(report.std.mass, report.interval95.mass, fit.mass, more.mass);
  for (int i = 0; i < 3; ++i)
    grow(report.std.com(i), report.interval95.com[static_cast<std::size_t>(i)], fit.com(i), more.com(i));
}

/// Unseen stretches come out no worse in force and torque, and better in one.
bool predictsBetter(const EstimateReport& is, const EstimateReport& was) {
  return is.heldoutForceRms < 1.02 * was.heldoutForceRms && is.heldoutTorqueRms < 1.02 * was.heldoutTorqueRms &&
         (is.heldoutForceRms < 0.95 * was.heldoutForceRms || is.heldoutTorqueRms < 0.95 * was.heldoutTorqueRms);
}

/// The recording as the sensor and the robot would have told it without the causes.
Result<Recording> freed(Recording cleaned, const RobotModel* robot, const Hypothesis& hypothesis) {
  Recording out = std::move(cleaned);
  if (!hypothesis.search.final.model.terms.empty()) {
    auto effect = effectOf(hypothesis.search.final.model, out, robot);
    if (!effect) return effect.error();
    out.wrench -= *effect;
  }
  return out;
}

/// Heavy enough to be there, and near the sensor.
bool possible(const EstimateReport& report) {
  return report.payload.mass > 3.0 * report.std.mass && report.payload.com.norm() < 0.4;
}

/// From a mass that could be relied on before.
bool movesFar(const EstimateReport& is, const EstimateReport& was) {
  if (was.trust == Trust::none) return false;
  return std::abs(is.payload.mass - was.payload.mass) > kMinorShare * std::abs(was.payload.mass);
}

void leaveAsItWas(DiagnosisReport& report, const Hypothesis& hypothesis, const char* code, std::string text,
                  std::string remedy) {
  report.after = report.before;
  widen(report.after, {}, ofUnknown(hypothesis, hypothesis.search.null));
  report.findings.push_back({Severity::warning, code, std::move(text), std::move(remedy), {}});
}

/// Whether the setup file's mount is to be turned: sensor axes are then other ones with it.
bool mountTurns(const nlohmann::json& metaChanges) {
  return metaChanges.contains(nlohmann::json::json_pointer("/sensor/mount/rpy_rad"));
}

}  // namespace

std::optional<Error> estimateAgain(DiagnosisReport& report, const Recording& recording, Recording cleaned,
                                   const RobotModel* robot, const Hypothesis& hypothesis,
                                   const EstimateOptions& options, const Progress& progress) {
  std::optional<Result<EstimateReport>> was, is;
  std::optional<Error> notFreed;
  const auto estimateOne = [&](std::size_t i) {
    if (i == 0) {
      was = estimate(recording, robot, options, progress);
    } else {
      const auto clean = freed(std::move(cleaned), robot, hypothesis);
      EstimateOptions same = options;
      same.silent = silentChannels(recording.wrench);
      if (clean)
        is = estimate(*clean, robot, same, progress);
      else
        notFreed = clean.error();
    }
  };
  constexpr Eigen::Index kMany =
      Eigen::Index{200} * 1000;  // Rows, of which both at once would take several hundred megabytes
  if (report.causes.empty()) {
    cleaned = {};
    estimateOne(0);
  } else if (recording.rows() < kMany) {
    parallelFor(2, estimateOne);
  } else {
    estimateOne(1);
    estimateOne(0);
  }
  if (!*was) return was->error();
  if (notFreed) return notFreed;
  report.before = std::move(**was);
  report.after = report.before;
  const bool unknown = report.verdict == Verdict::unexplained;
  if (report.causes.empty()) {
    if (unknown) widen(report.after, {}, ofUnknown(hypothesis, hypothesis.search.null));
    return std::nullopt;
  }
  if (!*is) return std::nullopt;
  report.after = std::move(**is);
  widen(report.after, ofFit(hypothesis.search.final), ofTies(report, hypothesis));
  if (unknown) widen(report.after, {}, ofUnknown(hypothesis, hypothesis.search.final));
  if (possible(report.before) && !possible(report.after)) {
    // Causes that leave an impossible payload explain nothing: they are shown, the payload stays as it was.
    report.verdict = Verdict::unexplained;
    leaveAsItWas(
        report, hypothesis, "causes_not_believable",
        heft::say("With these causes corrected the payload would be physically impossible, so it was left unchanged."),
        heft::say("Repeat the recording without touching anything."));
  } else if (unknown && !predictsBetter(report.after, report.before)) {
    leaveAsItWas(
        report, hypothesis, "payload_left_as_it_was",
        heft::say("Correcting these causes does not improve held-out segments, so the payload was left unchanged."),
        heft::say("Find the unknown part first: record the motion again, more slowly."));
  } else if (unknown && !report.mistake && movesFar(report.after, report.before)) {
    leaveAsItWas(report, hypothesis, "payload_left_as_it_was",
                 heft::say("With these causes corrected the payload would change by a quarter or more while something "
                           "unknown remains, so it was left unchanged."),
                 heft::say("Find the unknown part first: record the motion again, more slowly."));
  } else if (mountTurns(report.metaChanges())) {
    report.findings.push_back({Severity::info,
                               "payload_as_stated",
                               heft::say("The payload is given in the sensor frame that the setup file states."),
                               heft::say("If you use the corrected setup file, estimate again with it."),
                               {}});
  }
  return std::nullopt;
}

}  // namespace heft::diagnosis
