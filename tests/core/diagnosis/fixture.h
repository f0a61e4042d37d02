#pragma once
// Recordings for tests of the diagnosis.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/diagnosis/diagnose.h"
#include "core/motion/motion.h"
#include "core/simulation/simulate.h"

namespace heft::test {

inline Payload aTool() {
  Payload out;
  out.mass = 0.75;
  out.com = {0.01, -0.005, 0.06};
  out.inertiaCom = Vector3d(1.2e-3, 1.1e-3, 5e-4).asDiagonal();
  return out;
}

/// 12 s of a simulated Panda with the usual sensor.
inline Recording aRecording(MotionKind motion, std::uint64_t seed, std::vector<EffectRequest> effects = {}) {
  SimulateOptions options;
  options.motion = motion;
  options.seed = seed;
  options.duration = 12.0;
  options.effects = std::move(effects);
  return simulate(RobotModel::panda(), aTool(), options).value().recording;
}

inline DiagnosisReport diagnosed(const Recording& recording, std::vector<std::string> hidden = {}) {
  DiagnoseOptions options;
  options.surrogates = 0;
  options.hidden = std::move(hidden);
  return diagnose(recording, &RobotModel::panda(), options).value();
}

/// The same with a sensor that reads by `height` of each channel's range more on its way up than on its way down.
inline Recording withLoop(const Recording& still, double height) {
  Recording out = still;
  for (Eigen::Index c = 0; c < 6; ++c) {
    const double reach = 0.5 * height * (still.wrench.col(c).maxCoeff() - still.wrench.col(c).minCoeff());
    double bend = 0.0, last = still.wrench(0, c);
    for (Eigen::Index i = 0; i < still.rows(); ++i) {
      // What the gauges' noise does is no load.
      const Eigen::Index from = std::max<Eigen::Index>(0, i - 20), to = std::min(still.rows(), i + 21);
      const double load = still.wrench.col(c).segment(from, to - from).mean();
      bend = std::clamp(bend + load - last, -reach, reach);
      last = load;
      out.wrench(i, c) += bend;
    }
  }
  return out;
}

/// The motion's sample at a time [s].
inline Eigen::Index sampleAt(const Motion& motion, double t) {
  return std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::lround((t - motion.startTime) * motion.rateHz)), 0,
                                  motion.size() - 1);
}

/// Only the rows `kept` of a recording of joints.
inline Recording withRows(Recording recording, const std::vector<Eigen::Index>& kept) {
  recording.time = VectorXd(recording.time(kept));
  recording.q = MatrixXd(recording.q(kept, Eigen::all));
  if (recording.dq.rows() > 0) recording.dq = MatrixXd(recording.dq(kept, Eigen::all));
  recording.wrench = decltype(recording.wrench)(recording.wrench(kept, Eigen::all));
  return recording;
}

/// The cause of that name, or null.
inline const DiagnosedCause* named(const DiagnosisReport& report, std::string_view id) {
  const auto found = std::ranges::find_if(report.causes, [&](const auto& c) { return c.id == id; });
  return found == report.causes.end() ? nullptr : &*found;
}

/// Its parameter of that name, or null.
inline const CauseParameter* parameter(const DiagnosedCause& cause, std::string_view name) {
  const auto found = std::ranges::find_if(cause.parameters, [&](const auto& p) { return p.name == name; });
  return found == cause.parameters.end() ? nullptr : &*found;
}

/// What a failing test shows of a report.
inline std::string said(const DiagnosisReport& report) {
  std::string out(toString(report.verdict));
  for (const auto& cause : report.causes) out += " " + cause.id;
  return out + ", remaining " + report.remaining.goesWith;
}

}  // namespace heft::test
