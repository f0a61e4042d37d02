#include "core/simulation/simulate.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/simulation/sensor.h"
#include "core/simulation/trajectory.h"
#include "core/wrench/regressor.h"

namespace heft {

namespace {

/// Beyond this a recording would fill the memory of a usual machine.
constexpr double kMostRows = 2e7;
constexpr double kFewestRows = 10;

struct Check {
  const char* name;
  const char* unit;
  double value;
  bool mayBeZero;
};

/// An empty string if all is well.
std::string whatIsWrong(const SimulateOptions& options) {
  const SensorModel& s = options.sensor;
  const Check checks[] = {
      {"duration", " s", options.duration, false},
      {"rate", " Hz", options.rateHz, false},
      {"speed", "", options.speed, false},
      {"position noise", " rad", options.positionNoise, true},
      {"velocity quantum", " rad/s", options.velocityQuantum, true},
      {"force noise", " N", s.forceNoise, true},
      {"torque noise", " N m", s.torqueNoise, true},
      {"coloured force noise", " N", s.colouredForce, true},
      {"coloured torque noise", " N m", s.colouredTorque, true},
      {"correlation time of the coloured noise", " s", s.colourTime, true},
      {"force bias", " N", s.forceBias, true},
      {"torque bias", " N m", s.torqueBias, true},
      {"torque range", " N m", s.torqueRange, false},
      {"force resolution (x)", " N", s.forceResolution.x(), true},
      {"force resolution (y)", " N", s.forceResolution.y(), true},
      {"force resolution (z)", " N", s.forceResolution.z(), true},
      {"torque resolution (x)", " N m", s.torqueResolution.x(), true},
      {"torque resolution (y)", " N m", s.torqueResolution.y(), true},
      {"torque resolution (z)", " N m", s.torqueResolution.z(), true},
      {"force range (x)", " N", s.forceRange.x(), false},
      {"force range (y)", " N", s.forceRange.y(), false},
      {"force range (z)", " N", s.forceRange.z(), false},
  };
  for (const Check& check : checks) {
    if (std::isfinite(check.value) && (check.value > 0.0 || (check.mayBeZero && check.value == 0.0))) continue;
    return fmt::format("The {} of the simulation is {}{}; it must be {}.", check.name, check.value, check.unit,
                       check.mayBeZero ? "zero or more" : "positive");
  }
  const double rows = std::round(options.duration * options.rateHz);
  if (rows < kFewestRows || rows > kMostRows)
    return fmt::format("{} s at {} Hz make {} samples; {} to {} are possible: change the duration or the rate.",
                       options.duration, options.rateHz, rows, kFewestRows, kMostRows);
  if (!options.gravity.allFinite())
    return "The gravity of the simulation is not a finite vector; give three numbers in m/s2.";
  if (!options.mount.xyz.allFinite() || !options.mount.rpy.allFinite())
    return "The sensor mount of the simulation is not finite; give xyz in m and rpy in rad.";
  return {};
}

std::vector<Mark> marksOf(const std::vector<Contact>& contacts, double end) {
  std::vector<Mark> marks;
  double from = 0.0;
  for (const Contact& contact : contacts) {
    if (contact.from >= end) break;
    if (contact.from > from) marks.push_back({from, contact.from, MarkLabel::free});
    from = std::min(contact.to, end);
    marks.push_back({contact.from, from, MarkLabel::contact});
  }
  if (from < end || marks.empty()) marks.push_back({from, end, MarkLabel::free});
  return marks;
}

nlohmann::json toJson(const Vector3d& v) { return nlohmann::json::array({v.x(), v.y(), v.z()}); }

}  // namespace

std::string_view toString(MotionKind kind) {
  switch (kind) {
    case MotionKind::excitation:
      return "excitation";
    case MotionKind::pickAndPlace:
      return "pick-and-place";
    case MotionKind::free:
      break;
  }
  return "free";
}

std::optional<MotionKind> motionKindFromString(std::string_view text) {
  for (const MotionKind kind : {MotionKind::excitation, MotionKind::pickAndPlace, MotionKind::free})
    if (text == toString(kind)) return kind;
  return std::nullopt;
}

Result<Simulated> simulate(const RobotModel& robot, const Payload& payload, const SimulateOptions& options,
                           const Progress& progress) {
  if (const std::string wrong = whatIsWrong(options); !wrong.empty()) return Error{wrong};
  if (const Consistency consistency = checkPhysical(payload); !consistency.physical)
    return Error{fmt::format("The payload to simulate cannot exist: {}", consistency.reason)};
  if (robot.dof() == 0)
    return Error{fmt::format("Robot '{}' has no moving joint, so nothing can be simulated.", robot.name())};
  const std::optional<int> link = robot.findLink(options.mount.parent);
  if (!link)
    return Error{fmt::format("Robot '{}' has no link '{}' to mount the sensor on; its last link is '{}'.", robot.name(),
                             options.mount.parent, robot.links().empty() ? "" : robot.links().back().name)};

  progress(0.0, "planning the motion");
  const ToolFrame tool{*link, poseFromXyzRpy(options.mount.xyz, options.mount.rpy)};
  const auto trajectory = planTrajectory(robot, tool, payload, options);
  const std::vector<Contact> contacts = trajectory->contacts();

  const auto rows = static_cast<Eigen::Index>(std::llround(options.duration * options.rateHz));
  const Eigen::Index dof = robot.dof();
  Simulated out;
  Recording& recording = out.recording;
  recording.time.resize(rows);
  out.q.resize(rows, dof);
  out.dq.resize(rows, dof);
  out.ddq.resize(rows, dof);
  out.payloadWrench.resize(rows, 6);
  out.contactWrench.setZero(rows, 6);

  VectorXd q(dof), dq(dof), ddq(dof);
  std::size_t next = 0;  // the contact that is on or comes next
  for (Eigen::Index k = 0; k < rows; ++k) {
    if (k % 4096 == 0) {
      if (progress.cancelled()) return Error{"The simulation was stopped.", true};
      progress(static_cast<double>(k) / static_cast<double>(rows), "simulating");
    }
    const double t = static_cast<double>(k) / options.rateHz;
    recording.time(k) = t;
    trajectory->at(t, q, dq, ddq);
    out.q.row(k) = q;
    out.dq.row(k) = dq;
    out.ddq.row(k) = ddq;
    const FrameMotion motion = robot.frameMotion(tool.link, tool.X_LS, q, dq, ddq);
    const Matrix3d R_SB = motion.X_BS.linear().transpose();
    const WrenchState state{R_SB * (motion.a_BSo_B - options.gravity), R_SB * motion.w_BS_B, R_SB * motion.alpha_BS_B};
    out.payloadWrench.row(k) = predictWrench(payload, state);
    while (next < contacts.size() && t >= contacts[next].to) ++next;
    if (next < contacts.size()) {
      const Vector3d force = contacts[next].level(t) * (R_SB * contacts[next].force);
      out.contactWrench.row(k) << force.transpose(), contacts[next].point.cross(force).transpose();
    }
  }

  const Vector6d bias = drawBias(options.sensor, options.seed);
  recording.wrench = out.payloadWrench + out.contactWrench;
  measureWrench(options.sensor, options.seed, options.rateHz, bias, recording.wrench);
  recording.q = out.q;
  recording.dq = out.dq;
  measureJoints(options, recording.q, recording.dq);

  recording.meta.robot = options.robotReference;
  recording.meta.kind = RecordingKind::motion;
  recording.meta.mount = options.mount;
  recording.meta.sensorModel = options.sensor.name;
  recording.meta.wrenchSign = WrenchSign::sensorOnPayload;
  recording.meta.gravity = options.gravity;

  out.truth.payload = payload;
  out.truth.forceBias = bias.head<3>();
  out.truth.torqueBias = bias.tail<3>();
  out.truth.marks = marksOf(contacts, recording.time(rows - 1));
  out.truth.options = options;
  progress(1.0, "simulating");
  return out;
}

nlohmann::json toJson(const SimulationTruth& truth) {
  const SimulateOptions& o = truth.options;
  const SensorModel& s = o.sensor;
  nlohmann::json marks = nlohmann::json::array();
  for (const Mark& mark : truth.marks)
    marks.push_back({{"from_s", mark.from}, {"to_s", mark.to}, {"label", std::string(toString(mark.label))}});
  return {{"schema", "heft.truth/1"},
          {"payload", toJson(truth.payload)},
          {"bias", {{"force_n", toJson(truth.forceBias)}, {"torque_nm", toJson(truth.torqueBias)}}},
          {"marks", marks},
          {"options",
           {{"motion", std::string(toString(o.motion))},
            {"robot", o.robotReference},
            {"duration_s", o.duration},
            {"rate_hz", o.rateHz},
            {"speed", o.speed},
            {"seed", o.seed},
            {"gravity_m_s2", toJson(o.gravity)},
            {"mount", {{"parent", o.mount.parent}, {"xyz_m", toJson(o.mount.xyz)}, {"rpy_rad", toJson(o.mount.rpy)}}},
            {"position_noise_rad", o.positionNoise},
            {"velocity_quantum_rad_s", o.velocityQuantum},
            {"sensor",
             {{"model", s.name},
              {"force_noise_n", s.forceNoise},
              {"torque_noise_nm", s.torqueNoise},
              {"coloured_force_n", s.colouredForce},
              {"coloured_torque_nm", s.colouredTorque},
              {"colour_time_s", s.colourTime},
              {"force_resolution_n", toJson(s.forceResolution)},
              {"torque_resolution_nm", toJson(s.torqueResolution)},
              {"force_bias_n", s.forceBias},
              {"torque_bias_nm", s.torqueBias},
              {"force_range_n", toJson(s.forceRange)},
              {"torque_range_nm", s.torqueRange}}}}}};
}

}  // namespace heft
