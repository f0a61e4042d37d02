#pragma once
// Recordings for tests of the diagnosis.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/diagnosis/diagnose.h"
#include "core/motion/motion.h"
#include "core/simulation/random.h"
#include "core/simulation/simulate.h"
#include "core/wrench/regressor.h"

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

/// How the joints stand and move at one instant.
struct JointMotion {
  VectorXd q, dq, ddq;
};

struct Sampling {
  double rateHz = 0.0;
  double angles = 0.0;               ///< Noise [rad]
  double speeds = 0.0;               ///< Of reported velocities [rad/s]; 0: none are reported
  double force = 0.0, torque = 0.0;  ///< Of the sensor [N], [N m]
};

/// A mount that gives: the load comes through a spring.
struct Mount {
  double frequencyHz = 0.0;  ///< 0: it is rigid
  double damping = 0.0;
};

/// 20 s of a Panda that carries `tool` along `path`(time).
template <class Path>
Recording along(Path&& path, const Payload& tool, const Sampling& sampling, RandomStream& random,
                const Mount& mount = {}) {
  const RobotModel& robot = RobotModel::panda();
  Recording out = aRecording(MotionKind::pickAndPlace, 282);
  const auto rows = static_cast<Eigen::Index>(20.0 * sampling.rateHz);
  const int link = *robot.findLink(out.meta.mount.parent);
  const Isometry3d X_LS = poseFromXyzRpy(out.meta.mount.xyz, out.meta.mount.rpy);
  out.time = VectorXd::LinSpaced(rows, 0.0, static_cast<double>(rows - 1) / sampling.rateHz);
  out.q.resize(rows, 7);
  out.dq.resize(sampling.speeds > 0.0 ? rows : 0, 7);
  out.wrench.resize(rows, 6);
  Vector6d last = Vector6d::Zero(), felt = last, rate = last;
  for (Eigen::Index i = 0; i < rows; ++i) {
    const JointMotion at = path(out.time(i));
    const FrameMotion S = robot.frameMotion(link, X_LS, at.q, at.dq, at.ddq);
    const Matrix3d back = S.X_BS.linear().transpose();
    const Vector6d load =
        predictWrench(tool, {back * (S.a_BSo_B - out.meta.gravity), back * S.w_BS_B, back * S.alpha_BS_B});
    if (i == 0) felt = last = load;
    if (mount.frequencyHz > 0.0) {
      constexpr int kSteps = 20;
      const double w = 2.0 * std::numbers::pi * mount.frequencyHz, dt = 1.0 / sampling.rateHz / kSteps;
      const Vector6d slope = sampling.rateHz * (load - last);
      for (int step = 1; step <= kSteps; ++step) {
        const Vector6d now = last + step * dt * slope;
        rate += dt * (w * w * (now - felt) + 2.0 * mount.damping * w * (slope - rate));
        felt += dt * rate;
      }
    } else {
      felt = load;
    }
    last = load;
    for (Eigen::Index c = 0; c < 6; ++c)
      out.wrench(i, c) = felt(c) + (c < 3 ? sampling.force : sampling.torque) * random.normal();
    for (Eigen::Index j = 0; j < 7; ++j) {
      out.q(i, j) = at.q(j) + sampling.angles * random.normal();
      if (out.dq.rows() > 0) out.dq(i, j) = at.dq(j) + sampling.speeds * random.normal();
    }
  }
  return out;
}

/// The motion's sample at a time [s].
inline Eigen::Index sampleAt(const Motion& motion, double t) {
  return std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::lround((t - motion.startTime) * motion.rateHz)), 0,
                                  motion.size() - 1);
}

/// A recording of joints as one of the sensor's poses and twists.
inline Recording asPoses(Recording recording) {
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Eigen::Index rows = recording.rows();
  recording.q.resize(0, 0);
  recording.dq.resize(0, 0);
  recording.position.resize(rows, 3);
  recording.quaternion.resize(rows, 4);
  recording.twist.resize(rows, 6);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Matrix3d& R = motion.R_BS[static_cast<std::size_t>(k)];
    recording.position.row(i) = motion.position.col(k).transpose();
    recording.quaternion.row(i) = Quaterniond(R).coeffs().transpose();
    recording.twist.row(i) << motion.velocity.col(k).transpose(), (R * motion.omega.col(k)).transpose();
  }
  return recording;
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

/// Whether a finding of that code is among the report's.
inline bool finds(const DiagnosisReport& report, std::string_view code) {
  return std::ranges::any_of(report.findings, [&](const Finding& f) { return f.code == code; });
}

/// What a failing test shows of a report.
inline std::string said(const DiagnosisReport& report) {
  std::string out(toString(report.verdict));
  for (const auto& cause : report.causes) out += " " + cause.id;
  return out + ", remaining " + report.remaining.goesWith.english();
}

}  // namespace heft::test
