// Findings in words.
#include "core/diagnosis/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/diagnosis/pull.h"

namespace heft {
namespace {

using diagnosis::FrameMistake;

constexpr std::array kPatterns{"{:.0f}", "{:.1f}", "{:.2f}", "{:.3f}", "{:.4f}", "{:.5f}", "{:.6f}"};
constexpr int kMostDecimals = std::ssize(kPatterns) - 1;

std::string number(double value, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  if (std::abs(value) < 0.5 * unit) value = 0.0;  // Never -0.0
  return heft::say(fmt::runtime(kPatterns[static_cast<std::size_t>(std::clamp(decimals, 0, kMostDecimals))]), value);
}

/// As many decimals as the deviation bears.
/// With half of the 95 % interval, as everywhere where a person reads a number.
std::string plusMinus(double value, double deviation) {
  const double std = 1.96 * deviation;
  if (!(std > 0.0) || !std::isfinite(std))
    return number(value, std::abs(value) >= 100 ? 0 : std::abs(value) >= 1 ? 1 : 2);
  const double exponent = std::floor(std::log10(std));
  const bool small = std / std::pow(10.0, exponent) < 1.95;
  const int decimals = std::clamp(static_cast<int>(-exponent) + (small ? 1 : 0), 0, kMostDecimals);
  return number(value, decimals) + " \u00b1 " + number(std, decimals);
}

/// The parameters of one occurrence: those of the second end in _2, and so on.
struct Values {
  const DiagnosedCause& cause;
  std::string ending;

  const CauseParameter* find(std::string_view name) const {
    return findParameter(cause.parameters, std::string(name) + ending);
  }
  double value(std::string_view name) const {
    const auto* p = find(name);
    return p ? p->value : 0.0;
  }
  std::string size(std::string_view name) const {
    const auto* p = find(name);
    return p ? plusMinus(std::abs(p->value), p->std) : "0";
  }
  /// Length of up to three parameters with the largest of their deviations.
  std::string norm(std::initializer_list<std::string_view> names) const {
    double sum = 0.0, std = 0.0;
    for (const auto name : names)
      if (const auto* p = find(name)) {
        sum += p->value * p->value;
        std = std::max(std, p->std);
      }
    return plusMinus(std::sqrt(sum), std);
  }
  /// The largest of several parameters.
  std::string most(std::initializer_list<std::string_view> names) const {
    std::string_view best = *names.begin();
    for (const auto name : names)
      if (std::abs(value(name)) > std::abs(value(best))) best = name;
    return size(best);
  }
  /// Of a symmetric tensor, see tensorOf().
  double mostAlongAnyLine(std::string_view what) const {
    const Matrix3d tensor = diagnosis::tensorOf(what, cause.parameters, ending);
    return tensor.selfadjointView<Eigen::Lower>().eigenvalues().cwiseAbs().maxCoeff();
  }
  /// The one of this term that stands out most from its deviation.
  const CauseParameter* strongest() const {
    const CauseParameter* best = nullptr;
    double most = -1.0;
    for (const auto& p : cause.parameters) {
      if (occurrenceOf(p.name) != ending) continue;
      if (p.name.starts_with("time") || p.name.starts_with("turning_way") || p.name.starts_with("duration") ||
          p.name.starts_with("course_w") || p.name == "warm_up")
        continue;
      const double z = p.std > 0.0 ? std::abs(p.value) / p.std : 0.0;
      if (z > most) {
        most = z;
        best = &p;
      }
    }
    return best;
  }
};

int channelOf(std::string_view name) {
  constexpr std::array<std::string_view, 6> kNames{"fx", "fy", "fz", "tx", "ty", "tz"};
  for (std::size_t c = 0; c < kNames.size(); ++c)
    if (name.starts_with(kNames[c])) return static_cast<int>(c);
  return 0;
}

std::string driftSentence(const Values& v) {
  const CauseParameter* p = v.strongest();
  if (!p) return {};
  const std::string channel = channelWords(channelOf(p->name)), size = plusMinus(p->value, p->std);
  if (const auto per = p->unit.find("/pose"); per != std::string::npos)
    return heft::say("The sensor's zero drifts: {} by {} {} from each pose to the next.", channel, size,
                     p->unit.substr(0, per));
  if (p->unit.ends_with("/s"))
    return heft::say("The sensor's zero drifts: {} by {} {} per second.", channel, size,
                     p->unit.substr(0, p->unit.size() - 2));
  if (v.find("time_constant") && v.find("time"))
    return heft::say("From {} s on the sensor's zero creeps: {} by {} {} before it settles.",
                     number(v.value("time"), 1), channel, size, p->unit);
  if (v.find("course_w4") || v.find("course_w5"))
    return heft::say("The sensor's zero drifts to and fro: {} by {} {} in all.", channel,
                     plusMinus(std::abs(p->value), p->std), p->unit);
  return heft::say("The sensor's zero creeps: {} by {} {} before it settles.", channel, size, p->unit);
}

std::string dropoutSentence(const Values& v) {
  if (v.value("zero") > 0.0)
    return heft::say("{} % of the readings are zero throughout: lost packets.", v.size("zero"));
  if (v.find("replayed") && v.value("replayed") > std::max(v.value("repeated"), v.value("missing")))
    return heft::say("{} % of the readings were handed out a second time, in place of new ones.", v.size("replayed"));
  if (v.find("motion_repeated") && v.value("motion_repeated") > std::max(v.value("repeated"), v.value("missing")))
    return heft::say("{} % of the recorded positions repeat the one before, while the tool moved on.",
                     v.size("motion_repeated"));
  if (v.value("missing") > v.value("repeated"))
    return heft::say("{} % of the readings are missing.", v.size("missing"));
  return heft::say("{} % of the force readings repeat the one before.", v.size("repeated"));
}

std::string cableSentence(const Values& v) {
  if (v.value("twist_stiffness") < 0.0)
    return heft::say("Something twists the tool on the further it turns: {} N m per radian.",
                     v.size("twist_stiffness"));
  if (v.value("stiffness") < 0.0)
    return heft::say("Something, such as a bent hose, pushes the tool away from one spot: {} N per metre.",
                     v.size("stiffness"));
  if (v.find("twist_stiffness"))
    return heft::say("A cable twists back as the tool turns: {} N m per radian.", v.size("twist_stiffness"));
  if (v.find("hardening"))
    return heft::say(
        "A cable or hose, fixed to one spot, pulls the tool back: {} N per metre where it begins to stretch, and more "
        "the further it does.",
        v.size("stiffness"));
  if (v.find("length"))
    return heft::say(
        "A cable or hose, fixed to one spot and {} mm long when slack, pulls the tool back: {} N per metre.",
        v.size("length"), v.size("stiffness"));
  if (v.find("stiffness"))
    return heft::say("A cable or hose pulls the tool towards one spot: {} N per metre.", v.size("stiffness"));
  return heft::say("A cable or hose pulls the tool back, by up to {} N per metre.",
                   number(v.mostAlongAnyLine("stiffness"), 1));
}

/// A gain that depends on the sign of the load; empty if the strongest one does not.
std::string sidesSentence(const Values& v) {
  const std::string& name = v.strongest()->name;
  const std::string channel = name.substr(name.find('_') + 1, 2);
  const CauseParameter* asymmetry = v.find("asymmetry_" + channel);
  if (asymmetry == nullptr) return {};
  const CauseParameter* gain = v.find("gain_" + channel);
  const double both = gain != nullptr ? gain->value : 0.0;
  return heft::say("The channel {} is {:+.1f} % off to one side and {:+.1f} % to the other.",
                   channelWords(channelOf(channel)), both + asymmetry->value, both - asymmetry->value);
}

/// A joint whose angle is off to and fro once a turn; empty if the strongest parameter is of another kind.
std::string onceATurnSentence(const Values& v) {
  const std::string& name = v.strongest()->name;
  const auto once = name.find("_once_");
  if (once == std::string::npos) return {};
  const std::string both = name.substr(0, once + 6);
  return heft::say("Joint {} is read up to {} degrees wrong, to and fro once a turn.", name.substr(1, once - 1),
                   v.norm({both + "sine", both + "cosine"}));
}

/// Of those causes that change a reading: one parameter says which and how much.
std::string readingSentence(const std::string& id, const CauseParameter& p) {
  if (p.name.starts_with("gain_force"))
    return p.value > 0.0
               ? heft::say("All forces read {} % too much against the torques.", plusMinus(p.value, p.std))
               : heft::say("All forces read {} % too little against the torques.", plusMinus(-p.value, p.std));
  if (p.name == "growth")
    return heft::say("The gain of all channels changes by {:+.1f} % during the recording, as when a sensor warms up.",
                     p.value);
  if (p.name.starts_with("growth_"))
    return heft::say("The gain of {} changes by {:+.1f} % during the recording, as when a sensor warms up.",
                     channelWords(channelOf(std::string_view(p.name).substr(7))), p.value);
  if (id == "gain_error") {
    const std::string channel = channelWords(channelOf(std::string_view(p.name).substr(5)));
    return p.value > 0.0 ? heft::say("The channel {} reads {} % too much.", channel, plusMinus(p.value, p.std))
                         : heft::say("The channel {} reads {} % too little.", channel, plusMinus(-p.value, p.std));
  }
  if (id == "crosstalk") {
    const auto to = p.name.find("_to_");
    return heft::say("{} of {} shows up in {}.", parameterWords(p), channelWords(channelOf(p.name)),
                     channelWords(to == std::string::npos ? 0 : channelOf(std::string_view(p.name).substr(to + 4))));
  }
  if (id == "joint_offset")
    return heft::say("Joint {} is really {} degrees away from what was recorded.", p.name.substr(1, 1),
                     plusMinus(std::abs(p.value), p.std));
  if (p.name.starts_with("loop"))
    return heft::say(
        "The sensor remembers its load: it reads {} % of the load's range differently going up and coming down.",
        plusMinus(std::abs(p.value), p.std));
  return heft::say(
      "The sensor remembers {} of its load: it reads differently going up and coming down.",
      p.name.starts_with("memory") ? fmt::format("{} %", plusMinus(std::abs(p.value), p.std)) : parameterWords(p));
}

std::string sentenceOf(const Values& v, const std::optional<FrameMistake>& mistake) {
  const DiagnosedCause& cause = v.cause;
  const std::string& id = cause.id;
  if (id == "frame_error" || (id == "sensor_rotation" && cause.direct))
    return mistake ? mistake->sentence() : std::string();
  if (const CauseParameter* last = v.find("after_pose")) {
    const std::string pose = number(last->value, 0);
    if (id == "sensor_bias")
      return heft::say("After pose {} the sensor's zero jumped by {} N and {} N m.", pose, v.norm({"fx", "fy", "fz"}),
                       v.norm({"tx", "ty", "tz"}));
    return v.value("mass") > 0.0 ? heft::say("After pose {} the load was {} g heavier.", pose, v.size("mass"))
                                 : heft::say("After pose {} the load was {} g lighter.", pose, v.size("mass"));
  }
  if (id == "contact" && !cause.parameters.empty() && cause.parameters.front().name.starts_with("pose")) {
    std::string poses;
    for (const CauseParameter& p : cause.parameters)
      if (p.name.starts_with("pose")) poses += (poses.empty() ? "" : ", ") + number(p.value, 0);
    return heft::say("These poses do not fit the others, by up to {} N: {}. The tool touched something, or moved.",
                     number(v.value("peak_force"), 2), poses);
  }
  if (id == "sensor_bias")
    return v.find("fx") || v.find("fy") || v.find("fz")
               ? heft::say("At {} s the sensor's zero jumped by {} N.", number(v.value("time"), 1),
                           v.norm({"fx", "fy", "fz"}))
               : heft::say("At {} s the sensor's zero jumped by {} N m.", number(v.value("time"), 1),
                           v.norm({"tx", "ty", "tz"}));
  if (id == "bias_drift") return driftSentence(v);
  if (id == "time_offset" && v.find("clock_drift"))
    return heft::say("The clocks of force readings and motion run apart, by {} ms a second.", v.size("clock_drift"));
  if (id == "time_offset")
    return v.value("delay") > 0.0 ? heft::say("The force readings arrive {} ms late.", v.size("delay"))
                                  : heft::say("The force readings arrive {} ms before the motion.", v.size("delay"));
  if (id == "low_pass_lag") return heft::say("The force readings are smoothed over {} ms.", v.size("time_constant"));
  if (id == "motion_lag")
    return cause.direct ? heft::say("The reported velocities come {} ms late; Heft can use the positions instead.",
                                    v.size("lag"))
                        : heft::say("Accelerations come {} ms late; the angles do not.", v.size("lag"));
  if (id == "sensor_rotation") return heft::say("The sensor sits turned by {} degrees.", v.norm({"rx", "ry", "rz"}));
  if (id == "gravity_tilt" && v.find("sinks_x"))
    return heft::say("The robot's base tilts by {} degrees during the recording.", v.norm({"sinks_x", "sinks_y"}));
  if (id == "gravity_tilt")
    return heft::say("The robot's base is tilted by {} degrees against the stated gravity.",
                     v.norm({"tilt_x", "tilt_y"}));
  if (id == "gain_error" && v.strongest())
    if (const auto sides = sidesSentence(v); !sides.empty()) return sides;
  if (id == "joint_offset" && v.strongest())
    if (const auto sentence = onceATurnSentence(v); !sentence.empty()) return sentence;
  if (id == "gain_error" || id == "crosstalk" || id == "joint_offset" || id == "hysteresis")
    return v.strongest() ? readingSentence(id, *v.strongest()) : std::string();
  if (id == "cable_pull") return cableSentence(v);
  if (id == "constant_pull") {
    const std::string size = v.norm({"force_x", "force_y", "force_z"});
    return v.find("time")
               ? heft::say("From {} s on something pulls at the tool with {} N, always in the same direction.",
                           number(v.value("time"), 1), size)
               : heft::say("Something pulls at the tool with {} N, always in the same direction.", size);
  }
  if (id == "viscous_drag") {
    if (v.value("drag") < 0.0)
      return heft::say("Something, such as a hand at the tool, pushes the way it goes: {} N per metre per second.",
                       v.size("drag"));
    if (v.value("turning_drag") < 0.0)
      return heft::say("Something, such as a hand at the tool, turns it on: {} N m per radian per second.",
                       v.size("turning_drag"));
    if (v.find("drag")) return heft::say("Something holds the tool back: {} N per metre per second.", v.size("drag"));
    if (v.find("square_drag"))
      return heft::say("Something holds the tool back with the square of its speed: {} N at one metre per second.",
                       v.size("square_drag"));
    for (const char* what : {"drag", "tool_drag"})
      if (v.find(std::string(what) + "_xy"))
        return heft::say("Something holds the tool back, by up to {} N per metre per second.",
                         number(v.mostAlongAnyLine(what), 2));
    return v.find("drag_x")
               ? heft::say("Something holds the tool back, by up to {} N per metre per second.",
                           v.most({"drag_x", "drag_y", "drag_z"}))
               : heft::say("Something resists turning: {} N m per radian per second.", v.size("turning_drag"));
  }
  if (id == "coulomb_friction") {
    if (v.value("friction") < 0.0)
      return heft::say("Something, such as a hand at the tool, pushes the way it goes with {} N.", v.size("friction"));
    if (v.value("turning_friction") < 0.0)
      return heft::say("Something, such as a hand at the tool, turns it on with {} N m.", v.size("turning_friction"));
    if (v.find("friction")) return heft::say("Something rubs and holds the tool back with {} N.", v.size("friction"));
    return v.find("friction_x")
               ? heft::say("Something rubs and holds the tool back, with up to {} N.",
                           v.most({"friction_x", "friction_y", "friction_z"}))
               : heft::say("Something rubs and resists turning with {} N m.", v.size("turning_friction"));
  }
  if (const CauseParameter* mass = v.find("mass"); id == "loose_mass" && mass && v.value("damping") > 0.5)
    return mass->std > 0.5 * mass->value
               ? heft::say("Something in the tool is loose and rolls to another place as it turns.")
               : heft::say("About {} g in the tool are loose and roll to another place as it turns.", v.size("mass"));
  if (id == "loose_mass")
    return heft::say("About {} g in the tool are loose and swing {} times a second.", v.size("mass"),
                     number(v.value("frequency"), 1));
  if (id == "flexible_mount" && v.find("strikes"))
    return heft::say(
        "Something that carries the tool gives and rings at {} Hz when it is struck: its mount, or what the "
        "robot stands on.",
        number(v.value("frequency"), 0));
  if (id == "flexible_mount")
    return heft::say("The tool's mount gives and rings at {} Hz.", number(v.value("frequency"), 0));
  if (id == "payload_change" && cause.direct)
    return cause.when.size() == 1
               ? heft::say("From {} to {} s the tool carried {} g more.", number(cause.when[0].first, 1),
                           number(cause.when[0].second, 1), v.size("mass"))
               : heft::say("The tool carried {} g more {} times, first from {} to {} s.", v.size("mass"),
                           cause.when.size(), number(cause.when[0].first, 1), number(cause.when[0].second, 1));
  if (id == "payload_change" && v.value("duration") > 1.0) {
    const std::string from = number(v.value("time") - 0.5 * v.value("duration"), 1),
                      to = number(v.value("time") + 0.5 * v.value("duration"), 1);
    return v.value("mass") > 0.0 ? heft::say("From {} to {} s the load became {} g heavier.", from, to, v.size("mass"))
                                 : heft::say("From {} to {} s the load became {} g lighter.", from, to, v.size("mass"));
  }
  if (id == "payload_change" && v.find("mass") && std::abs(v.value("mass")) < 2.0 * v.find("mass")->std)
    return heft::say("At {} s the load moved on the tool; its weight hardly changed ({} g).",
                     number(v.value("time"), 1), plusMinus(v.value("mass"), v.find("mass")->std));
  if (id == "payload_change")
    return v.value("mass") > 0.0
               ? heft::say("At {} s the load became {} g heavier.", number(v.value("time"), 1), v.size("mass"))
               : heft::say("At {} s the load became {} g lighter.", number(v.value("time"), 1), v.size("mass"));
  if (id == "contact") {
    const double most = v.value("peak_force");
    const std::string peak = number(most, most < 0.95 ? 2 : 1);
    return cause.when.size() == 1
               ? heft::say("The tool touched something from {} to {} s, with up to {} N.",
                           number(cause.when[0].first, 1), number(cause.when[0].second, 1), peak)
               : heft::say("The tool touched something {} times, with up to {} N.", cause.when.size(), peak);
  }
  if (id == "saturation" && !cause.direct) {
    const auto loss = std::find_if(cause.parameters.begin(), cause.parameters.end(),
                                   [](const CauseParameter& p) { return p.name.starts_with("loss_"); });
    return loss == cause.parameters.end()
               ? std::string()
               : heft::say("Near the end of its range the channel {} shows {} % less than there is.",
                           channelWords(channelOf(std::string_view(loss->name).substr(5))),
                           plusMinus(loss->value, loss->std));
  }
  if (id == "saturation")
    return heft::say("The sensor reached the end of its range in {} % of the readings.", v.size("share"));
  if (id == "spikes")
    return heft::say("{} readings are spikes; Heft replaced them by what lies beside them.",
                     number(v.value("count"), 0));
  if (id == "lever_arm")
    return heft::say("The sensor's origin sits {} mm away from where the meta file puts it.",
                     v.norm({"dx", "dy", "dz"}));
  if (id == "derivative_noise" && v.find("noise"))
    return heft::say(
        "The reported velocities are noisy, by {} % of the motion's speed; Heft can use the positions instead.",
        v.size("noise"));
  if (id == "derivative_noise" && v.find("window"))
    return heft::say(
        "The reported velocities are means over {} ms, so that what is fast in them is too small; Heft can use the "
        "positions instead.",
        v.size("window"));
  if (id == "derivative_noise" && v.find("force_noise"))
    return heft::say(
        "The recorded motion is noisy: accelerations from it are {} N off, so Heft smooths it more, from {} Hz on.",
        number(v.value("force_noise"), 2), number(v.value("corner"), 0));
  if (id == "derivative_noise" && v.find("line"))
    return heft::say(
        "The motion is recorded every {} ms only, with straight lines between: accelerations from it are wrong at "
        "every corner.",
        number(v.value("line"), 0));
  if (id == "derivative_noise" && v.find("step_angle"))
    return heft::say("The joint angles come in steps of {} degrees: accelerations from them are rough.",
                     number(v.value("step_angle"), 2));
  if (id == "derivative_noise" && v.find("step_place"))
    return heft::say("The positions come in steps of {} mm: accelerations from them are rough.",
                     number(v.value("step_place"), 2));
  if (id == "derivative_noise" && v.find("position_smoothing"))
    return heft::say(
        "The positions were smoothed before they were recorded, by {} ms to either side, so that what is fast in them "
        "is too small.",
        v.size("position_smoothing"));
  if (id == "derivative_noise" && v.find("smoothing"))
    return heft::say(
        "The motion was smoothed before it was recorded, by {} ms to either side, so that what is fast in it is too "
        "small.",
        v.size("smoothing"));
  if (id == "derivative_noise")
    return cause.direct
               ? heft::say("The reported velocities are {} % off; Heft can use the positions instead.", v.size("loss"))
               : heft::say("The forces of acceleration are {} % off what the motion says.", v.size("loss"));
  if (id == "dropouts") return dropoutSentence(v);
  if (id == "jitter")
    return heft::say("The time stamps come up to {} ms early or late; Heft takes the rows as evenly spaced.",
                     number(0.5 * v.value("spread"), 1));
  if (id == "quantisation")
    return v.find("step_force")
               ? heft::say("The force readings come in steps of {}.", parameterWords(*v.find("step_force")))
           : v.find("step_torque")
               ? heft::say("The torque readings come in steps of {}.", parameterWords(*v.find("step_torque")))
               : std::string();
  return {};
}

/// Whether it pulls straight up all the time: a weight that is taken off the readings does exactly the same.
bool pullsUp(const DiagnosedCause& cause, const DiagnosisReport& report) {
  constexpr double kAside = 0.03;  // Share of the force
  const Values v{cause, {}};
  const Vector3d force(v.value("force_x"), v.value("force_y"), v.value("force_z")),
      down = report.mistake ? report.mistake->reading.gravity : report.meta.gravity;
  return !v.find("time") && force.dot(down) < 0.0 && force.cross(down).norm() < kAside * force.norm() * down.norm();
}

}  // namespace

std::string causeCheck(const DiagnosedCause& cause, const DiagnosisReport& report) {
  if (report.ofPoses && mountIsWrong(cause))
    return heft::say(
        "Correct how the sensor is mounted where the recorded poses are worked out: the recording states them itself, "
        "and the meta file's mount is not used.");
  const bool mixedUp = cause.direct && (cause.id == "frame_error" || cause.id == "sensor_rotation");
  if (mixedUp && report.mistake) return report.mistake->check();
  if (cause.id == "constant_pull" && pullsUp(cause, report))
    return heft::say(
        "It acts straight up: does the robot or the sensor's driver take a tool's weight off already? If not: is "
        "there a balancer or a hose that carries a part of it?");
  if (cause.id == "flexible_mount" && findParameter(cause.parameters, "strikes"))
    return heft::say(
        "Tap the tool, then what the robot stands on: which of them rings at this pitch? Tighten its screws.");
  return causeCheck(cause.id);
}

std::string channelWords(int channel) {
  const std::string axis(1, static_cast<char>('x' + channel % 3));
  return channel < 3 ? heft::say("force {}", axis) : heft::say("torque {}", axis);
}

std::string parameterWords(const CauseParameter& p) {
  // Small numbers in a large unit would be rounded away; degrees have a sign of their own.
  if (p.unit == "kg m") return plusMinus(1e3 * p.value, 1e3 * p.std) + " g m";
  if (p.unit == "deg") return plusMinus(p.value, p.std) + " \u00b0";
  return plusMinus(p.value, p.std) + (p.unit.empty() ? "" : " " + p.unit);
}

std::string causeSentence(const DiagnosedCause& cause, const std::optional<FrameMistake>& mistake) {
  std::string text = sentenceOf({cause, {}}, mistake);
  for (int i = 2;; ++i) {
    const std::string ending = fmt::format("_{}", i);
    if (std::none_of(cause.parameters.begin(), cause.parameters.end(),
                     [&](const auto& p) { return p.name.ends_with(ending); }))
      break;
    if (const std::string more = sentenceOf({cause, ending}, mistake); !text.ends_with(more)) text += " " + more;
  }
  return text.empty() ? cause.sentence : text;
}

std::string causeTitle(const DiagnosedCause& cause) {
  const CauseParameter* delay = findParameter(cause.parameters, "delay");
  if (cause.id == "time_offset" && delay && delay->value < 0.0) return heft::say("Motion late");
  return causeTitle(cause.id);
}

std::optional<int> sentenceChannel(const DiagnosedCause& cause) {
  const CauseParameter* p = Values{cause, {}}.strongest();
  if (!p) return std::nullopt;
  const std::string_view name = p->name;
  if (cause.id == "bias_drift") return channelOf(name);
  if (cause.id == "gain_error" && name.starts_with("gain_") && !name.starts_with("gain_force"))
    return channelOf(name.substr(5));
  if (const auto to = name.find("_to_"); cause.id == "crosstalk" && to != std::string_view::npos)
    return channelOf(name.substr(to + 4));
  return std::nullopt;
}

std::string goesWithWords(const std::string& goesWith) {
  double from = 0.0, to = 0.0;
  if (std::sscanf(goesWith.c_str(), "a rhythm of %lf Hz", &from) == 1)
    return from < 10.0 ? heft::say("a rhythm of {:.2g} Hz", from) : heft::say("a rhythm of {:.0f} Hz", from);
  if (std::sscanf(goesWith.c_str(), "a shaking of %lf to %lf Hz", &from, &to) == 2)
    return heft::say("a shaking of {:.0f} to {:.0f} Hz", from, to);
  if (std::sscanf(goesWith.c_str(), "slow swings, %lf to %lf times", &from, &to) == 2)
    return heft::say("slow swings, {:.1f} to {:.0f} times a second", from, to);
  if (int joint = 0; std::sscanf(goesWith.c_str(), "what the motor of joint %d does", &joint) == 1)
    return heft::say("what the motor of joint {} does", joint);
  return heft::say(fmt::runtime(goesWith));
}

}  // namespace heft
