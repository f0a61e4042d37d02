#include "core/import/field_name.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "core/import/time_column.h"

namespace heft {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kPoundForce = 4.4482216152605;  ///< [N], exact
constexpr double kKilopond = 9.80665;            ///< [N], exact; also the standard gravity [m/s2]
constexpr double kInch = 0.0254;                 ///< [m], exact
constexpr double kFoot = 0.3048;                 ///< [m], exact

struct UnitName {
  std::string_view name;  ///< Lower case, without blanks and dots.
  Quantity quantity;
  double si;
};

constexpr std::array kUnitNames = {
    UnitName{"s", Quantity::time, 1.0},
    UnitName{"sec", Quantity::time, 1.0},
    UnitName{"secs", Quantity::time, 1.0},
    UnitName{"second", Quantity::time, 1.0},
    UnitName{"seconds", Quantity::time, 1.0},
    UnitName{"sekunden", Quantity::time, 1.0},
    UnitName{"ms", Quantity::time, 1e-3},
    UnitName{"msec", Quantity::time, 1e-3},
    UnitName{"msecs", Quantity::time, 1e-3},
    UnitName{"millis", Quantity::time, 1e-3},
    UnitName{"milliseconds", Quantity::time, 1e-3},
    UnitName{"us", Quantity::time, 1e-6},
    UnitName{"\xB5s", Quantity::time, 1e-6},
    UnitName{"\xC2\xB5s", Quantity::time, 1e-6},
    UnitName{"\xCE\xBCs", Quantity::time, 1e-6},
    UnitName{"usec", Quantity::time, 1e-6},
    UnitName{"usecs", Quantity::time, 1e-6},
    UnitName{"micros", Quantity::time, 1e-6},
    UnitName{"microseconds", Quantity::time, 1e-6},
    UnitName{"ns", Quantity::time, 1e-9},
    UnitName{"nsec", Quantity::time, 1e-9},
    UnitName{"nsecs", Quantity::time, 1e-9},
    UnitName{"nanos", Quantity::time, 1e-9},
    UnitName{"nanosec", Quantity::time, 1e-9},
    UnitName{"nanosecs", Quantity::time, 1e-9},
    UnitName{"nanoseconds", Quantity::time, 1e-9},
    UnitName{"min", Quantity::time, 60.0},
    UnitName{"rad", Quantity::angle, 1.0},
    UnitName{"radian", Quantity::angle, 1.0},
    UnitName{"radians", Quantity::angle, 1.0},
    UnitName{"deg", Quantity::angle, kDegree},
    UnitName{"degree", Quantity::angle, kDegree},
    UnitName{"degrees", Quantity::angle, kDegree},
    UnitName{"grad", Quantity::angle, kDegree},  // German for degrees; no robot counts in gon
    UnitName{"\xB0", Quantity::angle, kDegree},
    UnitName{"\xC2\xB0", Quantity::angle, kDegree},
    UnitName{"rad/s", Quantity::angularRate, 1.0},
    UnitName{"deg/s", Quantity::angularRate, kDegree},
    UnitName{"degrees/s", Quantity::angularRate, kDegree},
    UnitName{"\xB0/s", Quantity::angularRate, kDegree},
    UnitName{"\xC2\xB0/s", Quantity::angularRate, kDegree},
    UnitName{"rpm", Quantity::angularRate, std::numbers::pi / 30.0},
    UnitName{"m", Quantity::length, 1.0},
    UnitName{"meter", Quantity::length, 1.0},
    UnitName{"meters", Quantity::length, 1.0},
    UnitName{"cm", Quantity::length, 0.01},
    UnitName{"mm", Quantity::length, 0.001},
    UnitName{"in", Quantity::length, kInch},
    UnitName{"m/s2", Quantity::acceleration, 1.0},
    UnitName{"m/s\xC2\xB2", Quantity::acceleration, 1.0},
    UnitName{"m/s/s", Quantity::acceleration, 1.0},
    UnitName{"g", Quantity::acceleration, kKilopond},
    UnitName{"mg", Quantity::acceleration, 1e-3 * kKilopond},
    UnitName{"n", Quantity::force, 1.0},
    UnitName{"newton", Quantity::force, 1.0},
    UnitName{"newtons", Quantity::force, 1.0},
    UnitName{"mn", Quantity::force, 1e-3},
    UnitName{"kn", Quantity::force, 1e3},
    UnitName{"lbf", Quantity::force, kPoundForce},
    UnitName{"lb", Quantity::force, kPoundForce},
    UnitName{"lbs", Quantity::force, kPoundForce},
    UnitName{"kgf", Quantity::force, kKilopond},
    UnitName{"kg", Quantity::force, kKilopond},  // of load cells
    UnitName{"kp", Quantity::force, kKilopond},
    UnitName{"gf", Quantity::force, 1e-3 * kKilopond},
    UnitName{"nm", Quantity::torque, 1.0},
    UnitName{"newtonmeter", Quantity::torque, 1.0},
    UnitName{"nmm", Quantity::torque, 1e-3},
    UnitName{"mnm", Quantity::torque, 1e-3},
    UnitName{"ncm", Quantity::torque, 1e-2},
    UnitName{"lbfin", Quantity::torque, kPoundForce* kInch},
    UnitName{"lbf-in", Quantity::torque, kPoundForce* kInch},
    UnitName{"inlbf", Quantity::torque, kPoundForce* kInch},
    UnitName{"in-lbf", Quantity::torque, kPoundForce* kInch},
    UnitName{"lbin", Quantity::torque, kPoundForce* kInch},
    UnitName{"lbfft", Quantity::torque, kPoundForce* kFoot},
    UnitName{"lbf-ft", Quantity::torque, kPoundForce* kFoot},
    UnitName{"ftlbf", Quantity::torque, kPoundForce* kFoot},
    UnitName{"ft-lbf", Quantity::torque, kPoundForce* kFoot},
    UnitName{"knm", Quantity::torque, 1e3},
    UnitName{"kgfm", Quantity::torque, kKilopond},
    UnitName{"kgfmm", Quantity::torque, 1e-3 * kKilopond},
    UnitName{"kgfcm", Quantity::torque, 1e-2 * kKilopond},
};

const UnitName* findUnit(std::string_view unit) {
  const auto found =
      std::find_if(kUnitNames.begin(), kUnitNames.end(), [&](const UnitName& each) { return each.name == unit; });
  return found == kUnitNames.end() ? nullptr : &*found;
}

/// Lower case, without blanks, dots and signs of multiplication.
std::string squeezed(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\xC2' && i + 1 < text.size() && text[i + 1] == '\xB7') {  // a raised dot
      ++i;
      continue;
    }
    if (c == '\xE2' && text.substr(i).starts_with("\xE2\x8B\x85")) {  // a dot operator
      i += 2;
      continue;
    }
    if (c != ' ' && c != '*' && c != '.' && c != '^') out += c;
  }
  return lowerCase(out);
}

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isLower(char c) { return c >= 'a' && c <= 'z'; }

/// "q1_deg", "dq1_rad_s": a unit as the last words of a name. Those of one letter need something before them that
/// cannot do without (an axis, a number, a word for time).
std::string takeTrailingUnit(Words& words) {
  if (words.size() >= 3 && words.back() == "s" && findUnit(words[words.size() - 2] + "/s") != nullptr) {
    const std::string unit = words[words.size() - 2] + "/s";
    words.resize(words.size() - 2);
    return unit;
  }
  if (words.empty()) return {};
  // "ZeitInNanoSec"
  if (const auto* const second = findUnit(words.back());
      words.size() >= 2 && second != nullptr && second->quantity == Quantity::time && second->si == 1.0) {
    const auto& part = words[words.size() - 2];
    const std::string unit = part == "nano" ? "ns" : part == "micro" ? "us" : part == "milli" ? "ms" : "";
    if (!unit.empty()) {
      words.resize(words.size() - 2);
      return unit;
    }
  }
  // "tx_n_m", "torque_kgf_cm_0"
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    const std::string torque = words[i] + words[i + 1];
    const auto* const force = findUnit(words[i]);
    const auto* const whole = findUnit(torque);
    if (force == nullptr || force->quantity != Quantity::force || whole == nullptr ||
        whole->quantity != Quantity::torque)
      continue;
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(i), words.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    return torque;
  }
  // "joint_pos_deg_1", "force_kgf_x"
  static constexpr std::array<std::string_view, 13> kInside = {"deg", "degrees", "rad", "mm", "nm",     "nmm",    "ncm",
                                                               "kgf", "gf",      "lbf", "kn", "newton", "newtons"};
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    if (std::find(kInside.begin(), kInside.end(), words[i]) == kInside.end()) continue;
    std::string unit = words[i];
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
    return unit;
  }
  // "force_n.x", "F_N[0]"
  for (std::size_t i = 1; i + 1 < words.size(); ++i)
    if (words[i] == "n" &&
        (words[i - 1] == "force" || words[i - 1] == "forces" || words[i - 1] == "kraft" || words[i - 1] == "f")) {
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
      return "n";
    }
  const std::string last = words.back();
  const auto* unit = findUnit(last);
  if (unit == nullptr || last == "in" || last == "min" || last == "lb" || last == "grad") return {};
  if (words.size() < 2 && (unit->quantity != Quantity::time || last.size() < 2)) return {};
  if (last.size() == 1) {
    const auto& before = words[words.size() - 2];
    const bool number = before[0] >= '0' && before[0] <= '9';
    const bool axis =
        before == "x" || before == "y" || before == "z" || (before.size() == 2 && before[1] >= 'x' && before[1] <= 'z');
    static constexpr std::array<std::string_view, 8> kTimes = {"time", "timestamp", "stamp", "t",
                                                               "ts",   "tm",        "clock", "elapsed"};
    const bool time = std::find(kTimes.begin(), kTimes.end(), before) != kTimes.end();
    if (!(last == "s" ? time : axis || number)) return {};
  }
  words.pop_back();
  return last;
}

}  // namespace

Words wordsOf(std::string_view name) {
  Words out;
  std::string current;
  int kind = 0;  // 1 letters, 2 digits
  const auto close = [&] {
    if (!current.empty()) out.push_back(lowerCase(current));
    current.clear();
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const int now = c >= '0' && c <= '9' ? 2 : isUpper(c) || isLower(c) ? 1 : 0;
    if (now != kind) close();
    // "forceX", "TCPForce" and "qMeas" are two words each; "Fx", "dQ" and "mX" are one.
    const bool wordFollows = i + 2 < name.size() && isLower(name[i + 1]) && isLower(name[i + 2]);
    if (now == 1 && current.size() == 1 && isLower(current.back()) && isUpper(c) && wordFollows) close();
    if (now == 1 && current.size() > 1 && isUpper(c)) {
      const bool afterLower = isLower(current.back());
      const bool newWord = isUpper(current.back()) && wordFollows;
      if (afterLower || newWord) close();
    }
    if (now != 0) current += c;
    kind = now;
  }
  close();
  return out;
}

FieldName readFieldName(std::string_view name) {
  while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
  FieldName out;
  if (name.size() > 2 && (name.back() == ']' || name.back() == ')')) {
    const auto open = name.find_last_of(name.back() == ']' ? '[' : '(');
    if (open != std::string_view::npos && open > 0) {
      auto unit = squeezed(name.substr(open + 1, name.size() - open - 2));
      // "wrench[3]" and "position[m]" of some joint m: only after a blank, or with more than one letter.
      const bool apart = name[open] == '(' || name[open - 1] == ' ' || unit.size() > 1;
      if (apart && findUnit(unit) != nullptr) {
        out.unit = std::move(unit);
        out.words = wordsOf(name.substr(0, open));
        return out;
      }
    }
  } else if (const auto slash = name.find_last_of("/,"); slash != std::string_view::npos && slash > 0) {
    // "Fx / N", "Fx, N"; a path such as /ft/force/x has no blank there.
    const bool blank = name[slash - 1] == ' ' || (slash + 1 < name.size() && name[slash + 1] == ' ');
    auto unit = squeezed(name.substr(slash + 1));
    if (blank && findUnit(unit) != nullptr) {
      out.unit = std::move(unit);
      out.words = wordsOf(name.substr(0, slash));
      return out;
    }
  }
  out.words = wordsOf(name);
  out.unit = takeTrailingUnit(out.words);
  return out;
}

std::optional<double> unitSi(std::string_view unit, Quantity quantity) {
  for (const auto& each : kUnitNames) {
    if (each.name != unit) continue;
    if (each.quantity == quantity) return each.si;
    // "rad" beside a velocity says rad/s.
    if (quantity == Quantity::angularRate && each.quantity == Quantity::angle) return each.si;
  }
  return std::nullopt;
}

std::string transformOf(std::string_view field) {
  constexpr std::string_view kBefore = "transforms[";
  const auto open = field.find(kBefore);
  const auto close = open == std::string_view::npos ? open : field.find(']', open);
  if (close == std::string_view::npos) return {};
  return std::string(field.substr(open + kBefore.size(), close - open - kBefore.size()));
}

}  // namespace heft
