#include "core/simulation/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/simulation/effects/effect.h"
#include "core/simulation/sensor.h"
#include "core/simulation/trajectory.h"

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
      {"position step", " rad", options.positionStep, true},
      {"velocity quantum", " rad/s", options.velocityQuantum, true},
      {"force noise", " N", s.forceNoise, true},
      {"torque noise", " N m", s.torqueNoise, true},
      {"coloured force noise", " N", s.colouredForce, true},
      {"coloured torque noise", " N m", s.colouredTorque, true},
      {"correlation time of the coloured noise", " s", s.colourTime, true},
      {"force bias", " N", s.forceBias, true},
      {"force walk", " N/sqrt(s)", s.forceWalk, true},
      {"torque walk", " N m/sqrt(s)", s.torqueWalk, true},
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

/// The arm and its tool from moment to moment.
class World {
 public:
  World(const RobotModel& robot, int link, const Geometry& geometry, const Payload& payload,
        const Trajectory& trajectory)
      : robot_(robot),
        link_(link),
        geometry_(geometry),
        payload_(payload),
        trajectory_(trajectory),
        contacts_(trajectory.contacts()),
        dq_(robot.dof()),
        ddq_(robot.dof()) {
    now_.gravity = geometry.gravity;
    now_.q.resize(robot.dof());
  }

  /// Times must rise.
  void go(double t) {
    now_.time = t;
    trajectory_.at(t, now_.q, dq_, ddq_);
    now_.motion = robot_.frameMotion(link_, geometry_.X_LS, now_.q, dq_, ddq_);
    const Matrix3d R_SB = now_.motion.X_BS.linear().transpose();
    now_.state = {R_SB * (now_.motion.a_BSo_B - geometry_.gravity), R_SB * now_.motion.w_BS_B,
                  R_SB * now_.motion.alpha_BS_B};
    payloadWrench_ = predictWrench(payload_, now_.state);
    contactWrench_.setZero();
    while (next_ < contacts_.size() && t >= contacts_[next_].to) ++next_;
    if (next_ < contacts_.size()) {
      const Vector3d force = contacts_[next_].level(t) * (R_SB * contacts_[next_].force);
      contactWrench_ << force, contacts_[next_].point.cross(force);
    }
  }

  const Instant& now() const { return now_; }
  const VectorXd& dq() const { return dq_; }
  const VectorXd& ddq() const { return ddq_; }
  const Vector6d& payloadWrench() const { return payloadWrench_; }
  const Vector6d& contactWrench() const { return contactWrench_; }

 private:
  const RobotModel& robot_;
  int link_;
  Geometry geometry_;
  const Payload& payload_;
  const Trajectory& trajectory_;
  std::vector<Contact> contacts_;
  std::size_t next_ = 0;  ///< The contact that is on or comes next
  Instant now_;
  VectorXd dq_, ddq_;
  Vector6d payloadWrench_ = Vector6d::Zero(), contactWrench_ = Vector6d::Zero();
};

EffectScene sceneOf(const RobotModel& robot, const ToolFrame& tool, const Payload& payload,
                    const SimulateOptions& options, const Trajectory& trajectory) {
  EffectScene scene;
  scene.robot = &robot;
  scene.payload = payload;
  scene.sensor = options.sensor;
  scene.gravity = options.gravity;
  scene.to = options.duration;
  scene.rateHz = options.rateHz;
  VectorXd q(robot.dof()), dq(robot.dof()), ddq(robot.dof());
  const int count = std::max(2, static_cast<int>(20.0 * options.duration));
  for (int i = 0; i <= count; ++i) {
    const double t = options.duration * i / count;
    trajectory.at(t, q, dq, ddq);
    scene.path.push_back({t, robot.linkPose(q, tool.link) * tool.X_LS});
  }
  return scene;
}

/// Cubic Lagrange interpolation at a fractional row, held beyond the ends.
Eigen::Matrix<double, 1, 6> rowAt(const SampledWrench& series, double row) {
  const Eigen::Index last = series.rows() - 1;
  const double at = std::clamp(row, 0.0, static_cast<double>(last));
  if (last < 3) return series.row(std::llround(at));
  const auto i = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(at), 1, last - 2);
  const double u = at - static_cast<double>(i);
  return -u * (u - 1.0) * (u - 2.0) / 6.0 * series.row(i - 1) +
         (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0 * series.row(i) - (u + 1.0) * u * (u - 2.0) / 2.0 * series.row(i + 1) +
         (u + 1.0) * u * (u - 1.0) / 6.0 * series.row(i + 2);
}

/// Samples from the finely integrated `gauges`, as late as the effects have it.
void takeLate(const Effects& effects, const SampledWrench& gauges, Eigen::Index margin, Eigen::Index fine,
              double fineRate, Simulated& out) {
  const Recording& recording = out.recording;
  const Eigen::Index rows = recording.time.size();
  out.signal.resize(rows, 6);
  for (Eigen::Index k = 0; k < rows; ++k) {
    double age = 0.0;
    for (const auto& effect : effects) age += effect->age(recording.time(k));
    const Eigen::Index fresh = margin + k * fine;
    if (age == 0.0) {
      out.signal.row(k) = gauges.row(fresh);
    } else {
      out.signal.row(k) = rowAt(gauges, static_cast<double>(fresh) - age * fineRate);
    }
  }
}

/// What sensor and log make of the signal; the bias.
Vector6d measure(const SimulateOptions& options, const Effects& effects, Simulated& out) {
  Recording& recording = out.recording;
  const Eigen::Index rows = recording.time.size();
  const Vector6d bias = drawBias(options.sensor, options.seed);
  SampledWrench noise = drawNoise(options.sensor, options.seed, options.rateHz, rows);
  for (const auto& effect : effects) effect->filter(noise, options.rateHz);
  recording.wrench = (out.signal.rowwise() + bias.transpose()) + noise;
  for (const auto& effect : effects) effect->shiftZero(recording.time, recording.wrench);
  for (const auto& effect : effects) effect->convert(recording.wrench);
  digitise(options.sensor, recording.wrench);
  recording.q = out.q;
  recording.dq = out.dq;
  measureJoints(options, recording.q, recording.dq);

  recording.meta.robot = options.robotReference;
  recording.meta.kind = RecordingKind::motion;
  recording.meta.mount = options.mount;
  recording.meta.sensorModel = options.sensor.name;
  recording.meta.wrenchSign = WrenchSign::sensorOnPayload;
  recording.meta.gravity = options.gravity;
  return bias;
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
  return simulateWith(
      robot, payload, options,
      [&](const EffectScene& scene) { return makeEffects(options.effects, options.seed, scene); }, progress);
}

Result<Simulated> simulateWith(const RobotModel& robot, const Payload& payload, const SimulateOptions& options,
                               const EffectSource& source, const Progress& progress) {
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
  SimulateOptions planned = options;
  planned.seed = options.motionSeed.value_or(options.seed);
  const auto trajectory = planTrajectory(robot, tool, payload, planned);
  auto made = source(sceneOf(robot, tool, payload, options, *trajectory));
  if (!made) return made.error();
  const Effects effects = std::move(*made);
  Geometry geometry{tool.X_LS, options.gravity};
  for (const auto& effect : effects) effect->alterGeometry(geometry);

  const auto rows = static_cast<Eigen::Index>(std::llround(options.duration * options.rateHz));
  const Eigen::Index dof = robot.dof();
  Simulated out;
  Recording& recording = out.recording;
  recording.time.resize(rows);
  out.q.resize(rows, dof);
  out.dq.resize(rows, dof);
  out.ddq.resize(rows, dof);
  out.payloadWrench.resize(rows, 6);
  out.contactWrench.resize(rows, 6);

  // What has a memory is integrated in finer steps, and the arm stands still for a while before and after, so that
  // late and early samples exist.
  constexpr double kFineRate = 2000.0, kMargin = 1.0;  // [Hz], [s]
  const Eigen::Index fine =
      effects.empty() ? 1 : std::max<Eigen::Index>(1, static_cast<Eigen::Index>(std::ceil(kFineRate / options.rateHz)));
  const double fineRate = options.rateHz * static_cast<double>(fine);
  const Eigen::Index margin =
      effects.empty() ? 0 : fine * static_cast<Eigen::Index>(std::ceil(kMargin * options.rateHz));
  SampledWrench gauges((rows - 1) * fine + 1 + 2 * margin, 6);
  World world(robot, tool.link, geometry, payload, *trajectory);
  for (Eigen::Index i = 0; i < gauges.rows(); ++i) {
    if (i % 4096 == 0) {
      if (progress.cancelled()) return Error{"The simulation was stopped.", true};
      progress(static_cast<double>(i) / static_cast<double>(gauges.rows()), "simulating");
    }
    world.go(static_cast<double>(i - margin) / fineRate);
    Vector6d load = world.payloadWrench() + world.contactWrench();
    for (const auto& effect : effects) load += effect->force(world.now(), 1.0 / fineRate);
    for (const auto& effect : effects) load = effect->gauge(load);
    gauges.row(i) = load;
    const Eigen::Index k = (i - margin) / fine;
    if (i < margin || (i - margin) % fine != 0 || k >= rows) continue;
    recording.time(k) = world.now().time;
    out.q.row(k) = world.now().q;
    out.dq.row(k) = world.dq();
    out.ddq.row(k) = world.ddq();
    out.payloadWrench.row(k) = world.payloadWrench();
    out.contactWrench.row(k) = world.contactWrench();
  }
  for (const auto& effect : effects) effect->filter(gauges, fineRate);
  takeLate(effects, gauges, margin, fine, fineRate, out);
  const Vector6d bias = measure(options, effects, out);
  for (const auto& effect : effects) effect->log(recording);

  out.truth.payload = payload;
  out.truth.forceBias = bias.head<3>();
  out.truth.torqueBias = bias.tail<3>();
  out.truth.marks = marksOf(trajectory->contacts(), static_cast<double>(rows - 1) / options.rateHz);
  for (const auto& effect : effects) out.truth.effects.push_back(effect->truth());
  out.truth.options = options;
  progress(1.0, "simulating");
  return out;
}

nlohmann::json toJson(const SimulationTruth& truth) {
  const SimulateOptions& o = truth.options;
  const SensorModel& s = o.sensor;
  nlohmann::json effects = nlohmann::json::array();
  for (const EffectTruth& effect : truth.effects) effects.push_back(toJson(effect));
  nlohmann::json marks = nlohmann::json::array();
  for (const Mark& mark : truth.marks)
    marks.push_back({{"from_s", mark.from}, {"to_s", mark.to}, {"label", std::string(toString(mark.label))}});
  return {{"schema", "heft.truth/1"},
          {"payload", toJson(truth.payload)},
          {"bias", {{"force_n", toJson(truth.forceBias)}, {"torque_nm", toJson(truth.torqueBias)}}},
          {"marks", marks},
          {"effects", effects},
          {"options",
           {{"motion", std::string(toString(o.motion))},
            {"robot", o.robotReference},
            {"duration_s", o.duration},
            {"rate_hz", o.rateHz},
            {"speed", o.speed},
            {"seed", o.seed},
            {"motion_seed", o.motionSeed.value_or(o.seed)},
            {"gravity_m_s2", toJson(o.gravity)},
            {"mount", {{"parent", o.mount.parent}, {"xyz_m", toJson(o.mount.xyz)}, {"rpy_rad", toJson(o.mount.rpy)}}},
            {"position_noise_rad", o.positionNoise},
            {"position_step_rad", o.positionStep},
            {"velocity_quantum_rad_s", o.velocityQuantum},
            {"sensor",
             {{"model", s.name},
              {"force_noise_n", s.forceNoise},
              {"torque_noise_nm", s.torqueNoise},
              {"coloured_force_n", s.colouredForce},
              {"coloured_torque_nm", s.colouredTorque},
              {"colour_time_s", s.colourTime},
              {"force_walk_n_sqrt_s", s.forceWalk},
              {"torque_walk_nm_sqrt_s", s.torqueWalk},
              {"force_resolution_n", toJson(s.forceResolution)},
              {"torque_resolution_nm", toJson(s.torqueResolution)},
              {"force_bias_n", s.forceBias},
              {"torque_bias_nm", s.torqueBias},
              {"force_range_n", toJson(s.forceRange)},
              {"torque_range_nm", s.torqueRange}}}}}};
}

}  // namespace heft
