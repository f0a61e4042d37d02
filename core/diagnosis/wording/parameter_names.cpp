// What a person reads for the parameters of causes, whose names in files are short: "Stiffness k", "Zero of force x".
#include <fmt/format.h>

#include <array>
#include <optional>

#include "core/base/say.h"
#include "core/diagnosis/wording/words.h"

namespace heft {
namespace {

struct Name {
  std::string_view name;
  const char* words;
};

constexpr std::array<Name, 45> kNames = {{
    {"delay", heft::toSay("Delay t")},
    {"clock_drift", heft::toSay("Clock drift")},
    {"lag", heft::toSay("Delay of the motion t")},
    {"time_constant", heft::toSay("Time constant T")},
    {"stiffness", heft::toSay("Stiffness k")},
    {"twist_stiffness", heft::toSay("Rotational stiffness k")},
    {"drag", heft::toSay("Drag d")},
    {"square_drag", heft::toSay("Quadratic drag d")},
    {"turning_drag", heft::toSay("Rotational drag d")},
    {"friction", heft::toSay("Friction F")},
    {"turning_friction", heft::toSay("Rotational friction M")},
    {"breakaway", heft::toSay("Extra friction at low speed F")},
    {"slow_speed", heft::toSay("Speed below which friction rises v")},
    {"way", heft::toSay("Displacement before it slips s")},
    {"stick_speed", heft::toSay("Speed below which it sticks v")},
    {"mass", heft::toSay("Mass m")},
    {"frequency", heft::toSay("Frequency f")},
    {"damping", heft::toSay("Damping ratio ζ")},
    {"strikes", heft::toSay("External blows, number")},
    {"time", heft::toSay("Time t")},
    {"duration", heft::toSay("Duration")},
    {"loss", heft::toSay("Missing share")},
    {"smoothing", heft::toSay("Smoothed over T")},
    {"position_smoothing", heft::toSay("Positions smoothed over T")},
    {"hardening", heft::toSay("Stiffening with stretch h")},
    {"length", heft::toSay("Length when slack L")},
    {"count", heft::toSay("Number")},
    {"share", heft::toSay("Share of the readings")},
    {"replayed", heft::toSay("Repeated readings")},
    {"spread", heft::toSay("Spread of the time stamps")},
    {"repeated", heft::toSay("Readings that repeat")},
    {"motion_repeated", heft::toSay("Positions that repeat")},
    {"zero", heft::toSay("Readings that are zero")},
    {"missing", heft::toSay("Readings that are missing")},
    {"peak_force", heft::toSay("Greatest force F")},
    {"memory", heft::toSay("Remembered share")},
    {"loop", heft::toSay("Height of the loop, as a share of the load's range")},
    {"turning_way", heft::toSay("Fades after, as a share of the load's range")},
    {"warm_up", heft::toSay("Time constant of warming up T")},
    {"step_force", heft::toSay("Step of the force readings")},
    {"line", heft::toSay("Time from corner to corner")},
    {"step_angle", heft::toSay("Step of the angles")},
    {"step_place", heft::toSay("Step of the positions")},
    {"window", heft::toSay("Averaged over T")},
    {"growth", heft::toSay("Gain change of all channels")},
}};

/// With an axis or a channel in place of {}.
constexpr std::array<Name, 14> kAlong = {{
    {"stiffness_", heft::toSay("Stiffness along {0}, k{0}")},
    {"force_", heft::toSay("Force along {0}, F{0}")},
    {"torque_", heft::toSay("Torque about {0}, M{0}")},
    {"drag_", heft::toSay("Drag along {0}, d{0}")},
    {"tool_drag_", heft::toSay("Drag along the tool's {0}, d{0}")},
    {"friction_", heft::toSay("Friction along {0}")},
    {"moment_", heft::toSay("Mass times offset along {0}, m{0}")},
    {"at_", heft::toSay("Position from the sensor, {0}")},
    {"slope_", heft::toSay("Share along {0}")},
    {"tilt_", heft::toSay("Tilt about {0}")},
    {"sinks_", heft::toSay("Increasing tilt about {0}")},
    {"start_", heft::toSay("Swing force at the start along {0}")},
    {"quarter_", heft::toSay("The same a quarter period later along {0}")},
    {"anchor_", heft::toSay("Attachment point, {0}")},
}};

std::optional<int> channelNamed(std::string_view name) {
  constexpr std::string_view kChannels[] = {"fx", "fy", "fz", "tx", "ty", "tz"};
  for (int c = 0; c < 6; ++c)
    if (name == kChannels[c]) return c;
  return std::nullopt;
}

/// One, or a pair of them.
bool isAxis(std::string_view text) {
  return text == "x" || text == "y" || text == "z" || text == "xy" || text == "xz" || text == "yz";
}

std::string wordsOf(std::string_view name) {
  for (const Name& each : kNames)
    if (name == each.name) return heft::say(fmt::runtime(each.words));
  for (const Name& each : kAlong)
    if (name.starts_with(each.name) && isAxis(name.substr(each.name.size())))
      return heft::say(fmt::runtime(each.words), name.substr(each.name.size()));
  if (const auto channel = channelNamed(name)) return heft::say("Size in {}", channelWords(*channel));
  if (name == "gain_force") return heft::say("Gain error of all forces");
  if (name == "step_torque") return heft::say("Step of the torque readings");
  if (name.size() == 2 && name[0] == 'r' && isAxis(name.substr(1)))
    return heft::say("Rotation about {}", name.substr(1));
  if (name.size() == 2 && name[0] == 'd' && isAxis(name.substr(1))) return heft::say("Offset along {}", name.substr(1));
  if (name.starts_with("gain_"))
    if (const auto channel = channelNamed(name.substr(5))) return heft::say("Gain error of {}", channelWords(*channel));
  if (name.starts_with("growth_"))
    if (const auto channel = channelNamed(name.substr(7)))
      return heft::say("Gain change of {}", channelWords(*channel));
  if (name.starts_with("asymmetry_"))
    if (const auto channel = channelNamed(name.substr(10)))
      return heft::say("Gain of {}, difference between directions", channelWords(*channel));
  if (name.starts_with("loss_"))
    if (const auto channel = channelNamed(name.substr(5)))
      return heft::say("Shortfall near the range limit, {}", channelWords(*channel));
  if (name.starts_with("knee_"))
    if (const auto channel = channelNamed(name.substr(5)))
      return heft::say("Width of that region, as a share of the range, {}", channelWords(*channel));
  if (name.starts_with("level_"))
    if (const auto channel = channelNamed(name.substr(6)))
      return heft::say("End of the range, {}", channelWords(*channel));
  if (name.size() == 8 && name.substr(2, 4) == "_to_") {
    const auto from = channelNamed(name.substr(0, 2)), to = channelNamed(name.substr(6));
    if (from && to) return heft::say("{} seen in {}", channelWords(*from), channelWords(*to));
  }
  if (name.starts_with("course_w")) return heft::say("Wave {} of the course", name.substr(8));
  if (name.ends_with("_slope"))
    if (const auto channel = channelNamed(name.substr(0, 2)); channel && name.size() == 8)
      return heft::say("Rate in {}", channelWords(*channel));
  if (name.ends_with("_bend"))
    if (const auto channel = channelNamed(name.substr(0, 2)); channel && name.size() == 7)
      return heft::say("Bend in {}", channelWords(*channel));
  if (const auto once = name.find("_once_"); once != std::string_view::npos && name[0] == 'q') {
    const auto joint = name.substr(1, once - 1);
    if (name.ends_with("_sine")) return heft::say("Angle error of joint {}, sine part", joint);
    if (name.ends_with("_cosine")) return heft::say("Angle error of joint {}, cosine part", joint);
  }
  if (name.ends_with("_offset") && name.size() > 8 && name[0] == 'q')
    return heft::say("Angle error of joint {}", name.substr(1, name.size() - 8));
  if (const auto wave = name.find("_wave_"); wave != std::string_view::npos)
    if (const auto channel = channelNamed(name.substr(0, wave)))
      return heft::say("Wave {} of {}", name.substr(wave + 6), channelWords(*channel));
  return {};
}

}  // namespace

std::string parameterName(std::string_view name) {
  std::string words = wordsOf(name);
  if (!words.empty()) return words;
  if (const auto ending = occurrenceOf(name); !ending.empty()) {
    words = wordsOf(name.substr(0, name.size() - ending.size()));
    if (!words.empty()) return heft::say("{} ({})", words, ending.substr(1));
  }
  return std::string(name);
}

}  // namespace heft
