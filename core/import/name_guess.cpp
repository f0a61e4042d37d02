#include "core/import/name_guess.h"

#include <array>
#include <vector>

namespace heft {

namespace {

bool isOne(const std::string& word, std::span<const char* const> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Words of values that nobody measured.
constexpr std::array kCommanded = {
    "d",         "cmd",       "command",     "commanded", "desired",   "des",       "target",     "ref",
    "reference", "goal",      "setpoint",    "limit",     "limits",    "error",     "errors",     "ddq",
    "qdd",       "dtau",      "dp",          "ddp",       "collision", "contact",   "std",        "stdev",
    "finger",    "gripper",   "covariance",  "planned",   "planner",   "simulated", "inaccuracy", "accuracy",
    "variance",  "tolerance", "uncertainty", "soll",      "increment", "inc",       "qcmd"};
/// Words of wrenches from which something was taken away, or that no sensor measured.
constexpr std::array kProcessed = {"compensated", "comp",     "bias", "unbiased", "zeroed",   "tared",
                                   "ext",         "external", "hat",  "estimate", "estimated"};

struct Doubt {
  int cost;
  std::vector<const char*> words;
};

std::optional<int> axis(const std::string& word) {
  if (word == "x") return 0;
  if (word == "y") return 1;
  if (word == "z") return 2;
  return std::nullopt;
}

Words without(const Words& words, std::size_t from, std::size_t count) {
  Words out(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(from));
  out.insert(out.end(), words.begin() + static_cast<std::ptrdiff_t>(from + count), words.end());
  return out;
}

constexpr std::array kForceWords = {"force", "forces", "f", "kraft", "fuerza", "forza"};
constexpr std::array kTorqueWords = {"torque", "torques", "moment",     "moments", "t",
                                     "m",      "tau",     "drehmoment", "couple",  "momento"};

}  // namespace

bool anyIs(const Words& tokens, std::span<const char* const> words) {
  return std::any_of(tokens.begin(), tokens.end(), [&](const std::string& t) { return isOne(t, words); });
}

bool isDigits(const std::string& word) { return !word.empty() && word[0] >= '0' && word[0] <= '9'; }

bool isCommanded(const Words& words) { return anyIs(words, kCommanded); }
bool isProcessed(const Words& words) { return anyIs(words, kProcessed); }

int doubtOf(const Words& words) {
  static const std::array kDoubts = {
      Doubt{4, {"filtered", "filter", "filt", "lowpass", "lp", "smoothed", "smooth", "butter", "kalman"}},
      Doubt{4, {"average", "averaged", "avg", "mean", "median", "downsampled", "decimated"}},
      Doubt{5, {"thresholded", "threshold", "deadband", "clipped", "saturated", "limited"}},
      Doubt{6, {"transformed", "tf", "rotated", "corrected", "calibrated", "scaled", "normalized"}},
      Doubt{8, {"world", "base", "global", "map", "odom", "robot_base"}},
      Doubt{8, {"tcp", "ee", "eef", "tool", "user", "cartesian"}},
      Doubt{6, {"estimated", "estimate", "est", "hat", "simulated", "sim", "virtual", "model", "predicted"}},
      Doubt{6, {"motor", "theta", "rotor"}}};
  int cost = 0;
  for (const auto& doubt : kDoubts)
    if (anyIs(words, doubt.words)) cost += doubt.cost;
  return cost;
}

std::optional<Member> asWrench(const FieldName& name) {
  const Words& words = name.words;
  static constexpr std::array kOther = {"pose",     "twist",        "position", "translation",
                                        "velocity", "acceleration", "joint"};
  if (anyIs(words, kOther)) return std::nullopt;
  for (std::size_t i = words.size(); i-- > 0;) {
    const auto& word = words[i];
    if (word.size() == 2 && (word[0] == 'f' || word[0] == 't' || word[0] == 'm'))
      if (const auto a = axis(word.substr(1))) return Member{*a + (word[0] == 'f' ? 0 : 3), without(words, i, 1)};
    if (i == 0) break;
    const auto& before = words[i - 1];
    std::optional<int> index = axis(word);
    const bool number = word.size() == 1 && word[0] >= '0' && word[0] <= '5';
    if (!index && number && i + 1 == words.size()) index = word[0] - '0';
    if (!index) continue;
    if (isOne(before, kForceWords) && *index < 3 && (before.size() > 1 || !number || i < 2 || !isDigits(words[i - 2])))
      return Member{*index, without(words, i - 1, 2)};
    if (isOne(before, kTorqueWords) && *index < 3) return Member{*index + 3, without(words, i - 1, 2)};
    // "Force1.x", of several sensors
    if (i < 2 || number || !isDigits(before) || words[i - 2].size() < 2) continue;
    for (const auto& [kind, first] : {std::pair{std::span<const char* const>(kForceWords), 0}, {kTorqueWords, 3}})
      if (isOne(words[i - 2], kind)) return Member{*index + first, without(without(words, i, 1), i - 2, 1)};
  }
  // In whatever language: an axis in newtons or newton metres.
  const auto last = words.empty() ? std::nullopt : axis(words.back());
  if (last && unitSi(name.unit, Quantity::force)) return Member{*last, Words(words.begin(), words.end() - 1)};
  if (last && unitSi(name.unit, Quantity::torque)) return Member{*last + 3, Words(words.begin(), words.end() - 1)};
  return std::nullopt;
}

std::optional<Member> asWrenchFromOne(const Words& words) {
  if (words.size() < 2 || words.back().size() != 1 || words.back()[0] < '1' || words.back()[0] > '3')
    return std::nullopt;
  const std::string& kind = words[words.size() - 2];
  const int index = words.back()[0] - '1';
  if (isOne(kind, kForceWords)) return Member{index, without(words, words.size() - 2, 2)};
  if (isOne(kind, kTorqueWords)) return Member{3 + index, without(words, words.size() - 2, 2)};
  return std::nullopt;
}

std::optional<Member> asWrenchArray(const Words& words) {
  if (words.size() < 2 || words.back().size() != 1 || !isDigits(words.back())) return std::nullopt;
  Words family(words.begin(), words.end() - 1);
  static constexpr std::array kLong = {"force", "forces", "wrench", "ft", "fts", "netft", "forcetorque", "loadcell"};
  static constexpr std::array kJoint = {"joint", "joints", "effort", "current", "motor", "stiffness"};
  // "F_meas_1" beside "q_meas_1"
  const bool measuredForce =
      anyIs(family, std::array{"f"}) && anyIs(family, std::array{"meas", "measured", "msr", "sensor", "ist"});
  if ((!anyIs(family, kLong) && !measuredForce) || anyIs(family, kJoint)) return std::nullopt;
  return Member{words.back()[0] - '0', std::move(family)};
}

std::optional<PoseMember> asPose(const Words& words) {
  static constexpr std::array kPlaces = {"position", "translation", "pos", "xyz", "p"};
  static constexpr std::array kTurns = {"orientation", "quaternion", "rotation", "quat", "ori", "q"};
  static constexpr std::array kRates = {"velocity", "vel", "twist",   "speed", "acceleration",
                                        "accel",    "acc", "angular", "linear"};
  if (words.empty() || anyIs(words, kRates)) return std::nullopt;
  for (std::size_t i = words.size(); i-- > 0;) {
    const auto& word = words[i];
    if (word.size() == 2 && (word[0] == 'p' || word[0] == 'q')) {
      const auto a = word[1] == 'w' ? std::optional<int>(3) : axis(word.substr(1));
      if (a && (word[0] == 'q' || *a < 3)) return PoseMember{{*a, without(words, i, 1)}, word[0] == 'q'};
    }
    // "pose_tx" beside "pose_qx"
    if (word.size() == 2 && word[0] == 't' && anyIs(words, std::array{"pose"}))
      if (const auto a = axis(word.substr(1))) return PoseMember{{*a, without(words, i, 1)}, false};
    if (i == 0) break;
    const auto a = word == "w" ? std::optional<int>(3) : axis(word);
    if (!a) continue;
    const auto& before = words[i - 1];
    if (isOne(before, kTurns)) return PoseMember{{*a, without(words, i - 1, 2)}, true};
    if (isOne(before, kPlaces) && *a < 3) return PoseMember{{*a, without(words, i - 1, 2)}, false};
  }
  return std::nullopt;
}

std::optional<Member> asMatrix(const Words& words) {
  static constexpr std::array kNames = {"r", "rot", "rotation", "matrix"};
  const auto digit = [](char c) { return c - '0'; };
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (!isOne(words[i - 1], kNames)) continue;
    if (words[i].size() == 2 && isDigits(words[i])) {
      const int row = digit(words[i][0]) - 1, column = digit(words[i][1]) - 1;
      if (row >= 0 && row < 3 && column >= 0 && column < 3) return Member{3 * row + column, without(words, i, 1)};
    }
    if (i + 1 < words.size() && words[i].size() == 1 && isDigits(words[i]) && words[i + 1].size() == 1 &&
        isDigits(words[i + 1])) {
      const int row = digit(words[i][0]), column = digit(words[i + 1][0]);
      if (row < 3 && column < 3) return Member{3 * row + column, without(words, i, 2)};
    }
  }
  return std::nullopt;
}

std::optional<JointMember> asJoint(const FieldName& name) {
  const Words& words = name.words;
  static constexpr std::array kPositions = {
      "position",     "positions",  "pos",          "q",          "angle",          "angles",
      "theta",        "winkel",     "gelenkwinkel", "achswinkel", "gelenkposition",
      "qmsr",  // KUKA's recorder
      "achsposition", "jointangle", "jointangles",  "jointpos",   "jointposition",  "jointpositions"};
  static constexpr std::array kVelocities = {"velocity",
                                             "velocities",
                                             "vel",
                                             "dq",
                                             "qd",
                                             "qdot",
                                             "speed",
                                             "speeds",
                                             "jointvel",
                                             "jointvelocity",
                                             "jointvelocities",
                                             "gelenkgeschwindigkeit"};
  static constexpr std::array kOther = {
      "effort",        "efforts",      "torque",  "torques", "tau",    "current", "currents",  "temperature",
      "temp",          "temperatures", "is",      "force",   "wrench", "voltage", "power",     "acceleration",
      "accelerations", "acc",          "jerk",    "mode",    "status", "moment",  "stiffness", "load",
      "tcp",           "pose",         "encoder", "ticks",   "fts",    "ft",      "column"};
  static constexpr std::array kJoints = {"joint", "joints", "j",   "axis", "a",   "jnt",
                                         "achse", "gelenk", "rax", "axe",  "eje", "articulacion"};
  if (words.empty() || anyIs(words, kOther)) return std::nullopt;
  const bool rate = unitSi(name.unit, Quantity::angularRate) && !unitSi(name.unit, Quantity::angle);
  const bool angle = unitSi(name.unit, Quantity::angle).has_value();
  // The number that tells the joint: the last one ("fr3_joint1" has another before it).
  const auto number =
      std::find_if(words.rbegin(), words.rend(), [](const std::string& t) { return t.size() <= 2 && isDigits(t); });
  if (number == words.rend()) return std::nullopt;
  const auto at = static_cast<std::size_t>(words.rend() - number) - 1;
  JointMember out;
  out.index = std::stoi(words[at]);
  out.family = words;
  out.family[at] = "#";
  // "dQ1" and "q_d1" are spelt alike but for the order.
  out.velocity = anyIs(words, kVelocities) || rate;
  if (out.velocity || anyIs(words, kPositions)) return out;
  static constexpr std::array kTurns = {"rpy",  "euler", "orientation", "rotation", "rot",
                                        "tool", "ee",    "eef",         "flange"};
  if (angle && !anyIs(words, kTurns)) return out;
  if (at > 0 && isOne(words[at - 1], kJoints)) return out;
  if (anyIs(words, std::array{"joint", "joints"})) return out;
  return std::nullopt;
}

std::optional<InertialMember> asInertial(const Words& words) {
  static constexpr std::array kAccelerations = {"acceleration", "accelerometer", "accel", "acc"};
  static constexpr std::array kRates = {"gyro", "gyr", "gyroscope"};
  static constexpr std::array kOther = {"joint", "joints", "ee", "eef", "tcp", "mag", "magnetometer"};
  if (anyIs(words, kOther)) return std::nullopt;
  for (std::size_t i = words.size(); i-- > 0;) {
    const auto& word = words[i];
    if (word.size() == 2 && (word[0] == 'a' || word[0] == 'w'))
      if (const auto a = axis(word.substr(1))) return InertialMember{{*a, without(words, i, 1)}, word[0] == 'w'};
    if (i == 0) break;
    auto index = axis(word);
    const auto& before = words[i - 1];
    const bool angular = anyIs(words, std::array{"angular"});
    if (!index && before == "accelerometer" && word.size() == 1 && word[0] >= '0' && word[0] <= '2')
      index = word[0] - '0';
    if (!index) continue;
    if (isOne(before, kAccelerations) && !angular) return InertialMember{{*index, without(words, i - 1, 2)}, false};
    if (isOne(before, kRates)) return InertialMember{{*index, without(words, i - 1, 2)}, true};
    if (before == "velocity" && angular) return InertialMember{{*index, without(words, i - 1, 2)}, true};
  }
  return std::nullopt;
}

bool isTcpForce(const Words& words) {
  return anyIs(words, std::array{"tcp"}) && anyIs(words, std::array{"force"}) && anyIs(words, std::array{"actual"});
}

}  // namespace heft
