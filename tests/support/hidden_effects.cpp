#include "tests/support/hidden_effects.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "core/wrench/rows.h"
#include "tests/support/random_tool.h"
#include "tests/support/unlisted_effects.h"

namespace heft::test {
namespace {

constexpr double kBlockHz = 50.0;

/// Kinds that show in single rows or in the joints, whatever the payload does: their typical size is the visible one.
const std::vector<std::string> kSeenDirectly{"saturation", "quantisation", "spikes",      "dropouts",        "repeats",
                                             "jitter",     "motion_lag",   "frame_error", "derivative_noise"};

/// Kinds that look alike; a pair or triple has one of a group at most.
const std::vector<std::vector<std::string>> kGroups{
    {"time_offset", "low_pass_lag", "motion_lag", "derivative_noise", "jitter", "dropouts", "repeats"},
    {"gravity_tilt", "constant_pull", "cable_pull", "joint_offset", "sensor_rotation", "frame_error"},
    {"viscous_drag", "coulomb_friction", "hysteresis"},
    {"gain_error", "crosstalk", "lever_arm"},
    {"payload_change", "contact", "bias_drift"},
    {"loose_mass", "flexible_mount"},
    {"saturation", "quantisation", "spikes"},
};

bool listed(const std::vector<std::string>& list, const std::string& id) {
  return std::find(list.begin(), list.end(), id) != list.end();
}

std::size_t groupOf(const std::string& id) {
  for (std::size_t i = 0; i < kGroups.size(); ++i)
    if (listed(kGroups[i], id)) return i;
  return kGroups.size();
}

SimulateOptions withoutNoise(SimulateOptions options) {
  SensorModel& s = options.sensor;
  s.forceNoise = s.torqueNoise = s.colouredForce = s.colouredTorque = s.forceBias = s.torqueBias = 0.0;
  s.forceWalk = s.torqueWalk = 0.0;
  s.forceResolution.setZero();
  s.torqueResolution.setZero();
  s.forceRange.setConstant(1e4);
  s.torqueRange = 1e4;
  options.positionNoise = options.velocityQuantum = 0.0;
  options.rateHz = 250.0;
  return options;
}

/// Squared residual of payload and bias fitted to the free part of a noiseless recording, over the noise's variance.
double residualEnergy(const Simulated& simulated, const SensorModel& noise, double rateHz) {
  const auto motion = motionOf(simulated.recording, &RobotModel::panda(), {});
  if (!motion) throw std::runtime_error(motion.error().message);
  const WrenchRows rows = rowsOf(*motion, kBlockHz);
  Vector6d scale;
  for (int c = 0; c < 6; ++c) {
    const double white = c < 3 ? noise.forceNoise : noise.torqueNoise;
    const double coloured = c < 3 ? noise.colouredForce : noise.colouredTorque;
    // Per block, by the spectral density at low frequencies: pessimistic for what is fast.
    const double variance = white * white * kBlockHz / rateHz + 2.0 * noise.colourTime * kBlockHz * coloured * coloured;
    scale(c) = 1.0 / std::sqrt(variance);
  }
  Eigen::Matrix<double, 16, 16> A = Eigen::Matrix<double, 16, 16>::Zero();
  Eigen::Matrix<double, 16, 1> b = Eigen::Matrix<double, 16, 1>::Zero();
  double total = 0.0;
  for (Eigen::Index k = 0; k < rows.size(); ++k) {
    const double t = rows.time(k);
    const bool touches = std::any_of(simulated.truth.marks.begin(), simulated.truth.marks.end(), [&](const Mark& m) {
      return m.label == MarkLabel::contact && t > m.from - 0.1 && t < m.to + 0.1;
    });
    if (touches) continue;
    Eigen::Matrix<double, 6, 16> J;
    J << rows.Y[static_cast<std::size_t>(k)], Matrix6d::Identity();
    J = scale.asDiagonal() * J;
    const Vector6d y = scale.cwiseProduct(rows.wrench.col(k));
    A += J.transpose() * J;
    b += J.transpose() * y;
    total += y.squaredNorm();
  }
  A.diagonal().array() += 1e-6;
  return std::max(0.0, total - b.dot(A.ldlt().solve(b)));
}

double misfitOf(const Payload& payload, const SimulateOptions& options, const EffectSource& source) {
  const SimulateOptions quiet = withoutNoise(options);
  const auto with = simulateWith(RobotModel::panda(), payload, quiet, source);
  const auto without = simulate(RobotModel::panda(), payload, quiet);
  if (!with || !without) throw std::runtime_error((with ? without : with).error().message);
  const double more =
      residualEnergy(*with, options.sensor, options.rateHz) - residualEnergy(*without, options.sensor, options.rateHz);
  return std::sqrt(std::max(0.0, more));
}

/// The size at which the misfit is kVisibleSigma, or nothing if that is out of all proportion.
template <class Misfit>
std::optional<double> visibleSize(double typical, double largest, const Misfit& misfitAt) {
  double size = typical;
  for (int round = 0; round < 2; ++round) {
    const double sigma = misfitAt(size);
    if (sigma < 1e-3) return std::nullopt;
    size *= std::clamp(kVisibleSigma / sigma, 0.02, 20.0);
    if (4.0 * size > largest || size > 12.0 * typical) return std::nullopt;
  }
  return size;
}

SimulateOptions drawOptions(HiddenCase kind, std::uint64_t seed, RandomStream& random, std::string& noise) {
  SimulateOptions options;
  options.seed = seed;
  constexpr MotionKind kMotions[] = {MotionKind::excitation, MotionKind::free, MotionKind::pickAndPlace};
  options.motion = kMotions[static_cast<std::size_t>(3.0 * random.uniform())];
  options.duration = random.uniform(10.0, 25.0);
  constexpr double kRates[] = {500.0, 800.0, 1000.0};
  options.rateHz = kRates[static_cast<std::size_t>(3.0 * random.uniform())];
  options.speed = random.uniform(0.6, 1.2);
  options.mount.xyz = {random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), random.uniform(0.02, 0.07)};
  options.mount.rpy = {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-3.1, 3.1)};
  SensorModel& s = options.sensor;
  const double level = std::exp(random.uniform(-0.6, 0.6));
  for (double* x : {&s.forceNoise, &s.torqueNoise, &s.colouredForce, &s.colouredTorque}) *x *= level;
  s.colourTime = random.uniform(0.02, 0.08);
  const double which = random.uniform();
  noise = "usual";
  if (kind == HiddenCase::walking) {
    noise = "walking";
    s.forceWalk = random.uniform(0.01, 0.04);
    s.torqueWalk = 0.02 * s.forceWalk;
  } else if (kind == HiddenCase::clean && which < 0.25) {
    noise = "white";
    s.colouredForce = s.colouredTorque = 0.0;
  } else if (kind == HiddenCase::clean && which < 0.5) {
    noise = "coloured";
    s.colouredForce *= 3.0;
    s.colouredTorque *= 3.0;
    s.forceNoise *= 0.3;
    s.torqueNoise *= 0.3;
  } else if (kind == HiddenCase::clean && which < 0.75) {
    noise = "doubled";
    for (double* x : {&s.forceNoise, &s.torqueNoise, &s.colouredForce, &s.colouredTorque}) *x *= 2.0;
  }
  return options;
}

Payload drawPayload(std::uint64_t seed) {
  std::mt19937 random(static_cast<std::mt19937::result_type>(seed * 2654435761u + 1));
  return randomTool(random).payload;
}

/// A request of the multiple of its visible size, or nothing if this motion cannot show the kind.
std::optional<EffectRequest> drawRequest(const EffectKind& kind, const std::string& form, double multiple,
                                         const Payload& payload, const SimulateOptions& options, RandomStream& random) {
  EffectRequest request{kind.id, form, kind.typical};
  if (kind.id == "frame_error") return request;  // There is no half mistake.
  if (!listed(kSeenDirectly, kind.id) || form == "recorded") {
    const auto size = visibleSize(kind.typical, kind.largest, [&](double s) {
      return misfit(payload, options, {kind.id, form, s});
    });
    if (!size) return std::nullopt;
    request.size = *size;
  }
  request.size = std::min(request.size * multiple, kind.largest);
  if (kind.either && random.chance(0.5)) request.size = -request.size;
  return request;
}

HiddenRecording finished(HiddenCase kind, std::uint64_t seed, const std::string& noise, double multiple,
                         Result<Simulated> simulated) {
  if (!simulated) throw std::runtime_error(simulated.error().message);
  HiddenRecording out;
  out.recording = std::move(simulated->recording);
  out.truth.kind = kind;
  out.truth.seed = seed;
  out.truth.noise = noise;
  out.truth.multiple = multiple;
  out.truth.simulation = std::move(simulated->truth);
  for (const Mark& mark : out.truth.simulation.marks)
    out.truth.touches = out.truth.touches || mark.label == MarkLabel::contact;
  for (const EffectTruth& effect : out.truth.simulation.effects) out.truth.ids.push_back(effect.id);
  return out;
}

}  // namespace

std::string_view toString(HiddenCase kind) {
  switch (kind) {
    case HiddenCase::clean:
      return "clean";
    case HiddenCase::walking:
      return "walking";
    case HiddenCase::single:
      return "single";
    case HiddenCase::variant:
      return "variant";
    case HiddenCase::pair:
      return "pair";
    case HiddenCase::triple:
      return "triple";
    case HiddenCase::unlisted:
      break;
  }
  return "unlisted";
}

std::vector<std::string> hideableIds() {
  std::vector<std::string> ids;
  for (const EffectKind& kind : effectKinds())
    if (kind.id != "sensor_bias") ids.push_back(kind.id);
  return ids;
}

double misfit(const Payload& payload, const SimulateOptions& options, const EffectRequest& request) {
  return misfitOf(payload, options,
                  [&](const EffectScene& scene) { return makeEffects({request}, options.seed, scene); });
}

HiddenRecording drawHidden(HiddenCase kind, std::uint64_t seed, double multiple, const std::string& id) {
  const RobotModel& robot = RobotModel::panda();
  // A motion that cannot show the drawn effect is replaced by another one.
  constexpr int kTries = 40;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const std::uint64_t own = seed * 64 + static_cast<std::uint64_t>(attempt);
    RandomStream random(own, RandomPurpose::effect, (1u << 21) + static_cast<std::uint64_t>(kind));
    std::string noise;
    SimulateOptions options = drawOptions(kind, own, random, noise);
    const Payload payload = drawPayload(own);
    constexpr double kMultiples[] = {1.0, 2.0, 4.0};
    const double drawn = kMultiples[static_cast<std::size_t>(3.0 * random.uniform())];
    const double times = multiple > 0.0 ? multiple : drawn;

    if (kind == HiddenCase::clean || kind == HiddenCase::walking)
      return finished(kind, seed, noise, 0.0, simulate(robot, payload, options));

    if (kind == HiddenCase::unlisted) {
      const auto& kinds = unlistedKinds();
      auto chosen = kinds.begin() + static_cast<std::ptrdiff_t>(seed % kinds.size());
      if (!id.empty()) chosen = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.id == id; });
      if (chosen == kinds.end()) throw std::runtime_error("no unlisted effect " + id);
      const auto source = [&](double size) {
        return [&, size](const EffectScene& scene) -> Result<Effects> {
          Effects effects;
          effects.push_back(makeUnlisted(*chosen, size, own, scene));
          return effects;
        };
      };
      const auto size =
          visibleSize(chosen->typical, 1e3, [&](double s) { return misfitOf(payload, options, source(s)); });
      if (!size) continue;
      auto hidden = finished(kind, seed, noise, times, simulateWith(robot, payload, options, source(*size * times)));
      hidden.truth.relatives = chosen->relatives;
      return hidden;
    }

    // The kinds take turns, so that every one comes equally often.
    std::vector<std::string> ids = hideableIds();
    if (kind == HiddenCase::variant)
      std::erase_if(ids, [](const std::string& i) { return findEffectKind(i)->forms.size() < 2; });
    const EffectKind* first = findEffectKind(id.empty() ? ids[seed % ids.size()] : id);
    if (first == nullptr) throw std::runtime_error("no effect " + id);
    std::vector<const EffectKind*> wanted{first};
    const std::size_t count = kind == HiddenCase::pair ? 2 : kind == HiddenCase::triple ? 3 : 1;
    while (wanted.size() < count) {
      const EffectKind* next =
          findEffectKind(ids[static_cast<std::size_t>(static_cast<double>(ids.size()) * random.uniform())]);
      if (std::none_of(wanted.begin(), wanted.end(),
                       [&](const EffectKind* w) { return groupOf(w->id) == groupOf(next->id); }))
        wanted.push_back(next);
    }
    for (const EffectKind* each : wanted) {
      std::string form = each->forms.front();
      if (kind == HiddenCase::variant && each->forms.size() > 1) {
        const auto others = static_cast<double>(each->forms.size() - 1);
        form = each->forms[1 + static_cast<std::size_t>(others * random.uniform())];
      }
      const auto request = drawRequest(*each, form, times, payload, options, random);
      if (request) options.effects.push_back(*request);
    }
    if (options.effects.size() != wanted.size()) continue;
    return finished(kind, seed, noise, times, simulate(robot, payload, options));
  }
  throw std::runtime_error("no motion shows the effect that was asked for");
}

nlohmann::json toJson(const HiddenTruth& truth) {
  nlohmann::json json = heft::toJson(truth.simulation);
  json["case"] = std::string(toString(truth.kind));
  json["draw"] = truth.seed;
  json["noise"] = truth.noise;
  json["multiple_of_visible"] = truth.multiple;
  json["relatives"] = truth.relatives;
  return json;
}

Result<HiddenTruth> hiddenTruthFromJson(const nlohmann::json& json, const std::string& where) {
  const auto payload = payloadFromJson(json, where);
  if (!payload) return payload.error();
  HiddenTruth truth;
  truth.simulation.payload = *payload;
  try {
    const std::string name = json.at("case").get<std::string>();
    const HiddenCase* kind = std::find_if(std::begin(kHiddenCases), std::end(kHiddenCases),
                                          [&](HiddenCase each) { return toString(each) == name; });
    if (kind == std::end(kHiddenCases)) return Error{where + ": there is no case '" + name + "'."};
    truth.kind = *kind;
    truth.seed = json.at("draw").get<std::uint64_t>();
    truth.noise = json.at("noise").get<std::string>();
    truth.multiple = json.at("multiple_of_visible").get<double>();
    truth.relatives = json.at("relatives").get<std::vector<std::string>>();
    for (const auto& mark : json.at("marks")) truth.touches = truth.touches || mark.at("label") == "contact";
    for (const auto& effect : json.at("effects")) {
      EffectTruth hidden{effect.at("effect").get<std::string>(),
                         effect.at("form").get<std::string>(),
                         effect.at("size").get<double>(),
                         effect.at("unit").get<std::string>(),
                         {},
                         {}};
      for (const auto& [key, value] : effect.at("parameters").items())
        hidden.parameters.push_back(
            {key, value.is_array() ? value.get<std::vector<double>>() : std::vector<double>{value.get<double>()}});
      truth.ids.push_back(hidden.id);
      truth.simulation.effects.push_back(std::move(hidden));
    }
  } catch (const nlohmann::json::exception& error) {
    return Error{where + " is no truth of a hidden effect: " + error.what()};
  }
  return truth;
}

}  // namespace heft::test
