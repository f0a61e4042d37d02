#include "core/compensation/compensation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/compensation/phases.h"
#include "core/math/statistics.h"
#include "core/wrench/regressor.h"

namespace heft {

namespace {

constexpr double kEnoughFree = 1.0;  // [s] of free motion that tell a bias

/// The payload's wrench at the recording's rows, between the motion's samples by a straight line.
WrenchSamples payloadShare(const VectorXd& time, const Motion& motion, const Vector10d& phi) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> onGrid(6, motion.size());
  for (Eigen::Index k = 0; k < motion.size(); ++k)
    onGrid.col(k) = regressor({motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)}) * phi;
  WrenchSamples share(time.size(), 6);
  for (Eigen::Index i = 0; i < time.size(); ++i) {
    const double place =
        std::clamp((time(i) - motion.startTime) * motion.rateHz, 0.0, static_cast<double>(motion.size() - 1));
    const auto k = std::min(static_cast<Eigen::Index>(place), std::max<Eigen::Index>(0, motion.size() - 2));
    const double part = place - static_cast<double>(k);
    share.row(i) = ((1.0 - part) * onGrid.col(k) + part * onGrid.col(std::min(k + 1, motion.size() - 1))).transpose();
  }
  return share;
}

std::vector<Phase> phaseOfRows(const VectorXd& time, const std::vector<PhaseSegment>& segments) {
  std::vector<Phase> out(static_cast<std::size_t>(time.size()), Phase::ignore);
  std::size_t s = 0;
  for (Eigen::Index i = 0; i < time.size() && !segments.empty(); ++i) {
    while (s + 1 < segments.size() && time(i) >= segments[s].to) ++s;
    out[static_cast<std::size_t>(i)] = segments[s].phase;
  }
  return out;
}

bool touchesNothing(Phase phase) { return phase == Phase::free || phase == Phase::approach; }

/// Root mean square over channels of what steps between differing neighbours say of the noise.
double scatter(const WrenchSamples& wrench, int first) {
  double sum = 0.0;
  for (int c = first; c < first + 3; ++c) {
    std::vector<double> steps;
    for (Eigen::Index i = 1; i < wrench.rows(); ++i)
      if (const double step = wrench(i, c) - wrench(i - 1, c); step != 0.0) steps.push_back(step);
    sum += std::pow(robustStd(steps), 2) / 2.0;
  }
  return std::sqrt(sum / 3.0);
}

void fillContacts(Compensated& out) {
  for (auto& segment : out.segments) {
    if (segment.phase != Phase::contact) continue;
    Vector6d sum = Vector6d::Zero();
    double count = 0.0;
    for (Eigen::Index i = 0; i < out.time.size(); ++i) {
      if (out.time(i) < segment.from || out.time(i) >= segment.to) continue;
      sum += out.wrench.row(i).transpose();
      count += 1.0;
      segment.peakForce = std::max(segment.peakForce, out.wrench.row(i).head<3>().norm());
    }
    // The sensor balances the contact, so the surroundings push the other way.
    sum /= -std::max(1.0, count);
    segment.meanForce = sum.head<3>();
    segment.meanTorque = sum.tail<3>();
  }
}

void chooseBias(const CompensateOptions& options, Compensated& out) {
  std::array<std::vector<double>, 6> free;
  double seconds = 0.0;
  for (Eigen::Index i = 0; i < out.time.size(); ++i) {
    if (!touchesNothing(out.phase[static_cast<std::size_t>(i)])) continue;
    if (i > 0) seconds += out.time(i) - out.time(i - 1);
    for (int c = 0; c < 6; ++c) free[static_cast<std::size_t>(c)].push_back(out.wrench(i, c));
  }
  out.bias = options.bias;
  if (seconds >= kEnoughFree) {
    out.ownBias = true;
    for (int c = 0; c < 6; ++c) out.bias(c) = median(free[static_cast<std::size_t>(c)]);
  } else {
    out.findings.push_back(
        {Severity::warning,
         "bias_of_result",
         heft::say("Only {:.1f} s are free of contact, so the bias of the result is subtracted; it may be out of date.",
                   seconds),
         heft::say("Record a second of free motion before the contact."),
         {}});
  }
}

}  // namespace

std::string_view toString(Phase phase) {
  switch (phase) {
    case Phase::free:
      return "free";
    case Phase::approach:
      return "approach";
    case Phase::contact:
      return "contact";
    case Phase::ignore:
      break;
  }
  return "ignore";
}

Result<Compensated> compensate(const Recording& recording, const RobotModel* robot, const CompensateOptions& options,
                               const Progress& progress) {
  EstimateOptions settings = options.estimate;
  settings.motion.outputRateHz = 0.0;  // every row is compensated
  settings.firstEstimate = options.payload;
  auto segmented = segmentRecording(recording, robot, settings, progress);
  if (!segmented) return segmented.error();
  Compensated out;
  out.findings = std::move(segmented->findings);
  out.time = recording.time;
  out.wrench = recording.wrench;
  out.wrench -= payloadShare(out.time, segmented->motion, toParameters(options.payload.payload));
  out.segments = phasesOf(segmented->segmentation.segments, segmented->motion);
  out.phase = phaseOfRows(out.time, out.segments);
  chooseBias(options, out);
  out.wrench.rowwise() -= out.bias.transpose();
  fillContacts(out);
  double force = 0.0, torque = 0.0, count = 0.0;
  for (Eigen::Index i = 0; i < out.time.size(); ++i) {
    if (!touchesNothing(out.phase[static_cast<std::size_t>(i)])) continue;
    force += out.wrench.row(i).head<3>().squaredNorm() / 3.0;
    torque += out.wrench.row(i).tail<3>().squaredNorm() / 3.0;
    count += 1.0;
  }
  out.freeForceRms = std::sqrt(force / std::max(1.0, count));
  out.freeTorqueRms = std::sqrt(torque / std::max(1.0, count));
  out.noiseForce = scatter(out.wrench, 0);
  out.noiseTorque = scatter(out.wrench, 3);
  if (count > 0.0 && out.freeForceRms > 3.0 * out.noiseForce && out.freeForceRms > 0.05)
    out.findings.push_back({Severity::warning,
                            "above_noise",
                            heft::say("In free motion {:.2g} N remain, but the sensor noise is only {:.2g} N: this is "
                                      "not the payload of this recording, or something else acts on the tool.",
                                      out.freeForceRms, out.noiseForce),
                            heft::say("Estimate the payload from this recording, or diagnose it."),
                            {}});
  return out;
}

Result<CompensateOptions> compensateOptionsFromJson(const nlohmann::json& result, const std::string& where) {
  auto payload = payloadGuessFromJson(result, where);
  if (!payload) return payload.error();
  CompensateOptions options;
  options.payload = *payload;
  const auto bias = result.is_object() ? result.find("bias") : result.end();
  if (!result.is_object() || bias == result.end()) return options;
  int at = 0;
  for (const char* key : {"force_n", "torque_nm"}) {
    const auto part = bias->is_object() ? bias->find(key) : bias->end();
    if (!bias->is_object() || part == bias->end() || !part->is_array() || part->size() != 3)
      return Error{fmt::format("{}: \"bias\" needs \"{}\" with three numbers.", where, key)};
    for (const auto& value : *part) {
      if (!value.is_number() || !std::isfinite(value.get<double>()))
        return Error{fmt::format("{}: \"{}\" of \"bias\" holds something that is not a number.", where, key)};
      options.bias(at++) = value.get<double>();
    }
  }
  return options;
}

}  // namespace heft
