#include "tests/support/parameter_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

namespace heft::test {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double number(const EffectTruth& hidden, const char* name, std::size_t index = 0) {
  const auto found =
      std::find_if(hidden.parameters.begin(), hidden.parameters.end(), [&](const auto& p) { return p.name == name; });
  return found == hidden.parameters.end() || index >= found->values.size() ? std::nan("") : found->values[index];
}

/// What the diagnosis should say, by the name of its parameter.
std::map<std::string, double> expected(const EffectTruth& hidden) {
  const std::string kind = hidden.id + "/" + hidden.form;
  std::map<std::string, double> out;
  const char* xyz = "xyz";
  const auto vector = [&](const char* stem, const char* name, double scale) {
    for (std::size_t i = 0; i < 3; ++i) out[std::string(stem) + xyz[i]] = scale * number(hidden, name, i);
  };
  if (kind == "time_offset/constant") out["delay"] = 1e3 * number(hidden, "delay_s");
  if (hidden.id == "hysteresis") out["memory"] = -100.0 * number(hidden, "share");
  if (hidden.id == "low_pass_lag") out["time_constant"] = 1e3 * number(hidden, "lag_s");
  if (hidden.id == "motion_lag") out["lag"] = 1e3 * number(hidden, "lag_s");
  if (kind == "derivative_noise/scaled") out["loss"] = 100.0 * number(hidden, "share");
  if (kind == "derivative_noise/recorded") out["smoothing"] = 1e3 * number(hidden, "width_s");
  if (kind == "gravity_tilt/tilt") vector("tilt_", "axis_b", kDegrees * number(hidden, "angle_rad"));
  if (hidden.id == "sensor_rotation") vector("r", "axis_s", kDegrees * number(hidden, "angle_rad"));
  if (kind == "lever_arm/offset") vector("d", "offset_s_m", 1e3);
  if (kind == "constant_pull/fixed") vector("force_", "force_b_n", 1.0);
  if (kind == "cable_pull/linear") out["stiffness"] = hidden.size;
  if (kind == "viscous_drag/linear") out["drag"] = hidden.size;
  if (kind == "coulomb_friction/dry") out["friction"] = hidden.size;
  if (kind == "payload_change/step") out["mass"] = 1e3 * number(hidden, "mass_kg");
  if (kind == "loose_mass/sprung") {
    out["mass"] = hidden.size;
    out["frequency"] = number(hidden, "frequency_hz");
  }
  // The joint stands that much less far than was recorded.
  if (hidden.id == "joint_offset")
    for (std::size_t i = 0; i < 7; ++i)
      out[fmt::format("q{}_offset", i + 1)] = -kDegrees * number(hidden, "offset_rad", i);
  return out;
}

}  // namespace

std::vector<double> parameterErrors(const EffectTruth& hidden, const nlohmann::json& cause) {
  std::vector<double> out;
  const nlohmann::json stated = cause.value("parameters", nlohmann::json::object());
  for (const auto& [name, value] : expected(hidden)) {
    const nlohmann::json parameter = stated.value(name, nlohmann::json::object());
    const double std = parameter.value("std", 0.0);
    if (std > 0.0 && std::isfinite(value)) out.push_back((parameter.value("value", 0.0) - value) / std);
  }
  return out;
}

}  // namespace heft::test
