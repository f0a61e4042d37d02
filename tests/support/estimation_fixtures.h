#pragma once
// Recordings and reports for tests of the estimator.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "core/estimation/estimate.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft::test {

/// A simulated recording that carries the truth as known payload.
inline Recording recordingOf(MotionKind kind, const Payload& payload, unsigned seed, double speed = 1.0) {
  SimulateOptions options;
  options.motion = kind;
  options.seed = seed;
  options.speed = speed;
  auto simulated = simulate(RobotModel::panda(), payload, options);
  if (!simulated) throw std::runtime_error(simulated.error().message);
  simulated->recording.meta.knownPayload = {payload.mass, payload.com, payload.inertiaCom};
  return std::move(simulated->recording);
}

/// The same arm held in its posture at row 5000 for the whole time.
inline Recording standingStill(Recording recording) {
  const Eigen::RowVectorXd q = recording.q.row(5000);
  const Eigen::RowVectorXd F = recording.wrench.row(5000);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    recording.q.row(k) = q;
    recording.dq.row(k).setZero();
    for (int c = 0; c < 6; ++c)
      recording.wrench(k, c) = F(c) + (c < 3 ? 0.02 : 0.001) * std::sin(12.9898 * static_cast<double>(k * 6 + c));
  }
  return recording;
}

inline EstimateReport reportOf(const Recording& recording, const EstimateOptions& options = {}) {
  auto report = estimate(recording, &RobotModel::panda(), options);
  if (!report) throw std::runtime_error(report.error().message);
  return *report;
}

inline bool has(const EstimateReport& report, std::string_view code) {
  return std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& f) { return f.code == code; });
}

}  // namespace heft::test
