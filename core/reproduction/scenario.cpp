#include "core/reproduction/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/motion/motion.h"
#include "core/simulation/random.h"
#include "core/simulation/sensor.h"
#include "core/wrench/regressor.h"

namespace heft {

namespace {

Payload box(double mass, const Vector3d& size, const Vector3d& centre) {
  const Vector3d s2 = size.cwiseAbs2();
  const Vector3d moments(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y());
  return {mass, centre, Matrix3d((mass / 12.0 * moments).asDiagonal())};
}

// Two blocks screwed together off the axis, so that no parameter is zero by symmetry. Sizes as of aluminium.
Payload blocks(double mass) {
  const double side = std::cbrt(mass / 2700.0);
  return composed(box(0.7 * mass, {1.1 * side, 0.8 * side, 0.9 * side}, {0.2 * side, -0.1 * side, 0.45 * side}),
                  box(0.3 * mass, {0.4 * side, 0.5 * side, 1.6 * side}, {-0.3 * side, 0.3 * side, 1.2 * side}));
}

Payload gripper() {
  const Payload body = box(0.62, {0.06, 0.20, 0.07}, {0.0, 0.005, 0.035});
  const Payload fingers = composed(box(0.09, {0.02, 0.02, 0.06}, {0.003, 0.035, 0.10}),
                                   box(0.09, {0.02, 0.02, 0.06}, {0.003, -0.030, 0.10}));
  return composed(body, fingers);
}

// The paper's smoothing: third order, a window of ten samples (widened to eleven, see MotionOptions), every sample.
MotionOptions paperMotion() {
  MotionOptions options;
  options.smoothing = SmoothingKind::savitzkyGolay;
  options.order = 3;
  options.window = 10;
  options.outputRateHz = 0.0;
  return options;
}

}  // namespace

std::vector<Scenario> paperScenarios(std::uint64_t seed, int repeats, double scale, double rateHz) {
  std::vector<Scenario> scenarios;
  const auto add = [&](std::string name, MotionKind motion, double duration, const Payload& payload) {
    Scenario scenario{std::move(name), motion != MotionKind::excitation, payload, {}};
    scenario.options.motion = motion;
    scenario.options.duration = scale * duration;
    scenario.options.rateHz = rateHz;
    scenario.options.seed = seed * 1000 + scenarios.size();
    scenarios.push_back(std::move(scenario));
  };
  for (int i = 0; i < repeats; ++i) {
    for (const double mass : {0.2, 0.35, 0.5})
      add(fmt::format("predefined motion, {:.2f} kg", mass), MotionKind::excitation, 20.0, blocks(mass));
    add("gripper, picking and placing by hand", MotionKind::pickAndPlace, 10.0, gripper());
    add("gripper, guided freely by hand", MotionKind::free, 10.0, gripper());
  }
  return scenarios;
}

Recording measured(const Simulated& simulated, const SensorFaults& faults) {
  const SimulateOptions& options = simulated.truth.options;
  const SampledWrench exact = simulated.payloadWrench + simulated.contactWrench;
  SampledWrench wrench = exact;
  if (faults.delay) {
    const double shift = kWrenchDelay * options.rateHz;
    for (Eigen::Index k = 0; k < exact.rows(); ++k) {
      const double at = std::max(0.0, static_cast<double>(k) - shift);
      const auto below = static_cast<Eigen::Index>(at);
      const Eigen::Index above = std::min(below + 1, exact.rows() - 1);
      const double part = at - static_cast<double>(below);
      wrench.row(k) = (1.0 - part) * exact.row(below) + part * exact.row(above);
    }
  }
  if (faults.tilt) {
    // About an axis across the flange: a turn about the flange's own axis would be seen when mounting.
    RandomStream stream(options.seed, RandomPurpose::bias, 100);
    const double direction = stream.uniform(0.0, 2.0 * std::numbers::pi);
    const Matrix3d R =
        rotationFromVector(kMountTilt * Vector3d(std::cos(direction), std::sin(direction), 0.0)).transpose();
    wrench.leftCols<3>() = (wrench.leftCols<3>() * R.transpose()).eval();
    wrench.rightCols<3>() = (wrench.rightCols<3>() * R.transpose()).eval();
  }
  Vector6d bias = Vector6d::Zero();
  if (faults.bias) bias << simulated.truth.forceBias, simulated.truth.torqueBias;
  measureWrench(options.sensor, options.seed, options.rateHz, bias, wrench);

  Recording recording = simulated.recording;
  recording.wrench = wrench;
  const Payload& payload = simulated.truth.payload;
  recording.meta.knownPayload = {payload.mass, payload.com, payload.inertiaCom};
  return recording;
}

Result<Recording> validationData(const Recording& recording, const RobotModel& robot, const Payload& payload) {
  const auto motion = motionOf(recording, &robot, paperMotion());
  if (!motion) return motion.error();
  Recording out = recording;
  const double rate = motion->rateHz;
  for (Eigen::Index k = 0; k < out.rows(); ++k) {
    const auto nearest = static_cast<Eigen::Index>(std::llround((out.time(k) - motion->startTime) * rate));
    const Eigen::Index at = std::clamp<Eigen::Index>(nearest, 0, motion->size() - 1);
    out.wrench.row(k) =
        predictWrench(payload, {motion->specificForce.col(at), motion->omega.col(at), motion->alpha.col(at)})
            .transpose();
  }
  return out;
}

Result<double> inertialTorque(const Recording& recording, const RobotModel& robot, const Payload& payload) {
  const auto motion = motionOf(recording, &robot, {});
  if (!motion) return motion.error();
  const Matrix3d inertia = inertiaAboutOrigin(payload);
  double sum = 0.0;
  for (Eigen::Index k = 0; k < motion->size(); ++k) {
    const Vector3d omega = motion->omega.col(k);
    sum += (inertia * motion->alpha.col(k) + omega.cross(inertia * omega)).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(motion->size()));
}

}  // namespace heft
