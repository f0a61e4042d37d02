#include "core/simulation/practice.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "core/simulation/effects/effect.h"

namespace heft {

namespace {

/// Numbers in a row give kinds in no order: a plain mixing of the bits.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

}  // namespace

const std::vector<std::string>& practiceKinds() {
  static const std::vector<std::string> kKinds{"cable_pull",  "time_offset",      "gravity_tilt",    "bias_drift",
                                               "sensor_bias", "coulomb_friction", "viscous_drag",    "loose_mass",
                                               "contact",     "payload_change",   "sensor_rotation", "low_pass_lag"};
  return kKinds;
}

EffectRequest practiceEffect(std::uint64_t seed) {
  const std::uint64_t bits = mixed(seed);
  EffectRequest out;
  out.id = practiceKinds()[bits % practiceKinds().size()];
  const EffectKind* kind = findEffectKind(out.id);
  // Clearly visible, not always equally so.
  const double factor = 1.0 + 1.5 * static_cast<double>((bits >> 32) % 1000) / 1000.0;
  out.size = kind ? kind->typical * factor : 0.0;
  return out;
}

namespace {

Result<Simulated> practised(std::uint64_t seed, std::vector<EffectRequest> effects, const Progress& progress) {
  SimulateOptions options;
  options.motion = mixed(seed + 1) % 3 == 0 ? MotionKind::excitation : MotionKind::free;
  options.duration = 15.0;
  options.seed = seed;
  options.effects = std::move(effects);
  Payload tool;
  tool.mass = 0.6 + 0.4 * static_cast<double>(mixed(seed + 2) % 100) / 100.0;
  tool.com = {0.004, -0.003, 0.055};
  tool.inertiaCom = Vector3d(0.0016, 0.0014, 0.0009).asDiagonal();
  return simulate(RobotModel::panda(), tool, options, progress);
}

}  // namespace

Result<Simulated> practiceRecording(std::uint64_t seed, const Progress& progress) {
  auto out = practised(seed, {practiceEffect(seed)}, progress);
  if (out) out->recording.meta.note = fmt::format("Practice recording {}", seed);
  return out;
}

Result<Simulated> practiceTwin(std::uint64_t seed, const Progress& progress) { return practised(seed, {}, progress); }

}  // namespace heft
