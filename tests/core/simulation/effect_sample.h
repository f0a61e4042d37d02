#pragma once
// One effect in a recording without noise, bias and converter steps, beside the same recording without it.
#include <stdexcept>

#include "core/simulation/effects/effect.h"
#include "tests/core/simulation/sample.h"

namespace heft {

inline SimulateOptions quietOptions(MotionKind motion = MotionKind::free, std::uint64_t seed = 5,
                                    double duration = 8.0) {
  SimulateOptions options = optionsFor(motion, seed, duration);
  SensorModel& s = options.sensor;
  s.forceNoise = s.torqueNoise = s.colouredForce = s.colouredTorque = s.forceBias = s.torqueBias = 0.0;
  s.forceResolution.setZero();
  s.torqueResolution.setZero();
  s.forceRange.setConstant(1e4);
  s.torqueRange = 1e4;
  options.positionNoise = options.velocityQuantum = 0.0;
  return options;
}

inline Simulated simulatedOrDie(const SimulateOptions& options) {
  auto simulated = simulate(RobotModel::panda(), sampleTool(), options);
  if (!simulated) throw std::runtime_error(simulated.error().message);
  return std::move(*simulated);
}

inline Simulated withEffect(const std::string& text, SimulateOptions options = quietOptions()) {
  auto effect = parseEffect(text);
  if (!effect) throw std::runtime_error(effect.error().message);
  options.effects.push_back(*effect);
  return simulatedOrDie(options);
}

/// A parameter of the first hidden effect.
inline std::vector<double> hidden(const Simulated& simulated, const std::string& name) {
  for (const EffectParameter& p : simulated.truth.effects.at(0).parameters)
    if (p.name == name) return p.values;
  throw std::runtime_error("no parameter " + name);
}
inline Vector3d hiddenVector(const Simulated& simulated, const std::string& name) {
  const auto values = hidden(simulated, name);
  return {values.at(0), values.at(1), values.at(2)};
}

/// The exact motion of S in row k, by forward kinematics of the exact joints.
inline FrameMotion motionAt(const Simulated& simulated, Eigen::Index k) {
  const RobotModel& robot = RobotModel::panda();
  const SensorMount& mount = simulated.truth.options.mount;
  return robot.frameMotion(*robot.findLink(mount.parent), poseFromXyzRpy(mount.xyz, mount.rpy),
                           simulated.q.row(k).transpose(), simulated.dq.row(k).transpose(),
                           simulated.ddq.row(k).transpose());
}

/// What the effect adds to the rigid payload's wrench and the scene's contacts.
inline SampledWrench added(const Simulated& simulated) {
  return simulated.signal - simulated.payloadWrench - simulated.contactWrench;
}

}  // namespace heft
