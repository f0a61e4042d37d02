#include "core/recording/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

namespace {

constexpr int kMaxJoints = 64;
constexpr std::array<const char*, 3> kPosition = {"px", "py", "pz"};
constexpr std::array<const char*, 4> kQuaternion = {"qx", "qy", "qz", "qw"};
constexpr std::array<const char*, 6> kTwist = {"vx", "vy", "vz", "wx", "wy", "wz"};
constexpr std::array<const char*, 3> kAccelerometer = {"ax", "ay", "az"};
/// Without a sensor's velocities, "wx" to "wz" beside an accelerometer mean the same.
constexpr std::array<const char*, 3> kGyroscope = {"imu_wx", "imu_wy", "imu_wz"};
constexpr std::array<const char*, 6> kWrench = {"fx", "fy", "fz", "tx", "ty", "tz"};

template <class Names>
std::optional<int> indexIn(const Names& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<int>(found - names.begin());
}

/// 0-based joint of "PREFIX7".
std::optional<int> jointIndex(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  int number = 0;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (failure != std::errc() || end != name.data() + name.size() || name.front() == '0') return std::nullopt;
  if (number < 1 || number > kMaxJoints) return std::nullopt;
  return number - 1;
}

Column meaningOf(std::string_view name) {
  if (name == "time") return {Role::time, 0};
  if (name == "label") return {Role::label, 0};
  if (const auto i = jointIndex(name, "q")) return {Role::joint, *i};
  if (const auto i = jointIndex(name, "dq")) return {Role::jointVelocity, *i};
  if (const auto i = indexIn(kPosition, name)) return {Role::position, *i};
  if (const auto i = indexIn(kQuaternion, name)) return {Role::quaternion, *i};
  if (const auto i = indexIn(kTwist, name)) return {Role::twist, *i};
  if (const auto i = indexIn(kAccelerometer, name)) return {Role::accelerometer, *i};
  if (const auto i = indexIn(kGyroscope, name)) return {Role::gyroscope, *i};
  if (const auto i = indexIn(kWrench, name)) return {Role::wrench, *i};
  return {};
}

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return out;
}

/// "PX [mm]" is px in mm.
struct NamedUnit {
  std::string name;
  std::string unit;  ///< Lower case; empty if none is stated.
};

NamedUnit splitUnit(std::string_view text) {
  const auto open = text.find_first_of("[(");
  if (open == std::string_view::npos || open == 0 || (text.back() != ']' && text.back() != ')'))
    return {lowered(text), {}};
  auto name = text.substr(0, open);
  while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
  return {lowered(name), lowered(text.substr(open + 1, text.size() - open - 2))};
}

/// The unit that a column is in by what the setup file states; SI where it states nothing.
std::string columnUnit(Column column, const Conventions& conventions) {
  const std::string angle = conventions.radPerAngle == 1.0 ? "rad" : "deg";
  const std::string length = conventions.mPerLength == 1.0 ? "m" : "mm";
  const bool torqueFirst = conventions.wrenchOrder == Conventions::WrenchOrder::torqueFirst;
  const auto named = [](const Conventions::Unit& unit, const char* si) { return unit.si == 1.0 ? si : unit.name; };
  switch (column.role) {
    case Role::time:
      return "s";
    case Role::joint:
      return angle;
    case Role::jointVelocity:
      return angle + "/s";
    case Role::position:
      return length;
    case Role::twist:
      return (column.index < 3 ? length : angle) + "/s";
    case Role::accelerometer:
      return conventions.mPerS2PerAcceleration == 1.0 ? "m/s2" : "g";
    case Role::gyroscope:
      return angle + "/s";
    case Role::wrench:
      return (column.index < 3) != torqueFirst ? named(conventions.force, "N") : named(conventions.torque, "N m");
    case Role::quaternion:
    case Role::label:
    case Role::extra:
      return {};
  }
  return {};
}

/// Lower case, without blanks, dots and multiplication signs.
std::string squeezedUnit(std::string_view text) {
  std::string out;
  for (const char c : lowered(text))
    if (c != ' ' && c != '*' && c != '.' && c != '^' && c != '\xC2' && c != '\xB7') out += c;
  return out;
}

bool isUnit(std::string_view stated, std::string_view si) {
  const auto unit = squeezedUnit(stated);
  return unit.empty() || unit == squeezedUnit(si) || (si == "s" && (unit == "sec" || unit == "seconds"));
}

/// Anything else in brackets ("q1 (filtered)") is a remark, and the column another one than the name before it says.
bool isForeignUnit(std::string_view stated) {
  static constexpr std::array kUnits = {"deg", "degree", "degrees", "\xB0", "deg/s", "\xB0/s", "degrees/s", "rpm",
                                        "mm",  "cm",     "mm/s",    "cm/s", "in",    "inch",   "ms",        "us",
                                        "ns",  "min",    "mn",      "kn",   "nmm",   "ncm",    "mnm",       "kgf",
                                        "lbf", "g",      "kg",      "gf",   "lbfin", "lbfft"};
  const auto unit = squeezedUnit(stated);
  return std::find(kUnits.begin(), kUnits.end(), unit) != kUnits.end();
}

class Mapper {
 public:
  Mapper(const std::vector<std::string>& names, const RecordingMeta& meta, const Location& header, Findings& findings)
      : names_(names), meta_(meta), header_(header), findings_(findings) {}

  Result<ColumnMap> map() {
    if (auto failure = assign()) return *failure;
    collect();
    if (auto failure = requireAll()) return *failure;
    noteUnknown();
    return std::move(map_);
  }

 private:
  Location at(long field) const { return {header_.file, header_.line, field}; }
  void note(Severity severity, const char* code, long field, std::string text, std::string remedy = {}) {
    findings_.push_back({severity, code, std::move(text), std::move(remedy), at(field)});
  }

  /// Gives every field its meaning. Names written exactly as in the contract come first; looser ones (case, unit) count
  /// only where no exact one stands.
  std::optional<Error> assign() {
    map_.columns.resize(names_.size());
    std::map<std::pair<Role, int>, long> exact;
    std::map<std::pair<Role, int>, long> loose;
    for (std::size_t f = 0; f < names_.size(); ++f) {
      const auto field = static_cast<long>(f) + 1;
      if (const auto meaning = meaningOf(names_[f]); meaning.role != Role::extra) {
        const auto [first, fresh] = exact.emplace(std::pair(meaning.role, meaning.index), field);
        if (!fresh) return duplicate(field, first->second);
        map_.columns[f] = meaning;
      }
    }
    std::vector<std::string> normalised;
    for (std::size_t f = 0; f < names_.size(); ++f) {
      const auto field = static_cast<long>(f) + 1;
      const auto [name, unit] = splitUnit(names_[f]);
      const auto meaning = meaningOf(name);
      if (meaning.role == Role::extra || map_.columns[f].role != Role::extra) continue;
      const std::pair key(meaning.role, meaning.index);
      const auto expected = columnUnit(meaning, meta_.conventions);
      const auto si = columnUnit(meaning, {});
      // Counts have no unit that could be told apart from a remark.
      const bool counts = meaning.role == Role::wrench && expected.empty();
      const bool right = counts || isUnit(unit, expected);
      if (exact.contains(key) || (!right && !isForeignUnit(unit) && !isUnit(unit, si))) continue;
      if (!right)
        return errorAt(at(field),
                       expected == si ? heft::say("column \"{}\" is not in SI units.", printable(names_[f]))
                                      : heft::say("column \"{}\" is in another unit than the one stated, {}.",
                                                  printable(names_[f]), expected),
                       heft::say("Convert it to {} and name it {}, or state the unit of all such columns in the setup "
                                 "file.",
                                 si, columnName(meaning.role, meaning.index)));
      const auto [first, fresh] = loose.emplace(key, field);
      if (!fresh) return duplicate(field, first->second);
      map_.columns[f] = meaning;
      normalised.push_back(heft::say("\"{}\" as {}", printable(names_[f]), columnName(meaning.role, meaning.index)));
    }
    if (!normalised.empty())
      note(Severity::info, "names_normalised", 0, heft::say("Read {}.", fmt::join(normalised, ", ")));
    return std::nullopt;
  }

  Error duplicate(long field, long first) const {
    const auto& meaning = printable(names_[static_cast<std::size_t>(field) - 1]);
    return errorAt(at(field), heft::say("column {} appears twice: also as column {}.", meaning, first),
                   heft::say("Rename or delete one of them."));
  }

  void collect() {
    for (std::size_t f = 0; f < names_.size(); ++f) {
      const auto field = static_cast<long>(f) + 1;
      const auto index = static_cast<std::size_t>(map_.columns[f].index);
      const auto put = [&](std::vector<long>& list) {
        if (list.size() <= index) list.resize(index + 1, 0);
        list[index] = field;
      };
      switch (map_.columns[f].role) {
        case Role::time:
          map_.time = field;
          break;
        case Role::joint:
          put(map_.joints);
          break;
        case Role::jointVelocity:
          put(map_.velocities);
          break;
        case Role::position:
          map_.position[index] = field;
          break;
        case Role::quaternion:
          map_.quaternion[index] = field;
          break;
        case Role::twist:
          map_.twist[index] = field;
          break;
        case Role::accelerometer:
          map_.accelerometer[index] = field;
          break;
        case Role::gyroscope:
          map_.gyroscope[index] = field;
          break;
        case Role::wrench:
          map_.wrench[index] = field;
          break;
        case Role::label:
          map_.label = field;
          break;
        case Role::extra:
          break;
      }
    }
    if (meta_.robot == "panda" && !map_.joints.empty() && map_.joints.size() < 7) map_.joints.resize(7, 0);
  }

  template <class Fields>
  static std::vector<std::string> missingOf(Role role, const Fields& fields) {
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (fields[i] == 0) missing.push_back(columnName(role, static_cast<int>(i)));
    return missing;
  }
  template <class Fields>
  static bool anyOf(const Fields& fields) {
    return std::any_of(fields.begin(), fields.end(), [](long field) { return field > 0; });
  }

  void setAside(Role role, const std::string& why) {
    long first = 0;
    for (std::size_t f = 0; f < map_.columns.size() && first == 0; ++f)
      if (map_.columns[f].role == role) first = static_cast<long>(f) + 1;
    note(Severity::warning, "columns_set_aside", first, why);
    map_.setAside(role);
  }

  std::optional<Error> requireAll() {
    std::vector<std::string> missing;
    if (map_.time == 0 && meta_.kind == RecordingKind::motion) missing.push_back("time");
    for (auto& name : missingOf(Role::wrench, map_.wrench)) missing.push_back(std::move(name));

    const auto noJoints = missingOf(Role::joint, map_.joints);
    const auto noQuaternion = missingOf(Role::quaternion, map_.quaternion);
    const auto noPosition = missingOf(Role::position, map_.position);
    const bool joints = !map_.joints.empty() && noJoints.empty();
    const bool orientation = noQuaternion.empty();
    const bool halfPosition = anyOf(map_.position) && !noPosition.empty();
    std::string neither;
    if (!joints && !orientation) {
      if (anyOf(map_.joints)) {
        for (const auto& name : noJoints) missing.push_back(name);
      } else if (anyOf(map_.quaternion)) {
        for (const auto& name : noQuaternion) missing.push_back(name);
      } else {
        neither = heft::say(
            "there is no motion: neither joint positions q1..q7 nor the sensor's pose px, py, pz, qx, qy, qz, qw "
            "(qx, qy, qz, qw alone will do)");
      }
    } else if (!joints && halfPosition) {
      for (const auto& name : noPosition) missing.push_back(name);
    }
    if (!missing.empty() || !neither.empty()) return missingColumns(missing, neither);

    if (anyOf(map_.joints) && !joints)
      setAside(Role::joint, heft::say("Column {} is missing, so the joints are ignored and the sensor's pose is used.",
                                      fmt::join(noJoints, ", ")));
    if (anyOf(map_.quaternion) && !orientation)
      setAside(Role::quaternion,
               heft::say("Column {} is missing, so the sensor's pose is ignored and the joints are used.",
                         fmt::join(noQuaternion, ", ")));
    if (anyOf(map_.position) && (halfPosition || !orientation))
      setAside(Role::position,
               orientation ? heft::say("Column {} is missing, so the position is ignored and the joints are used.",
                                       fmt::join(noPosition, ", "))
                           : heft::say("A position without an orientation is ignored."));
    if (!map_.velocities.empty() &&
        (map_.velocities.size() != map_.joints.size() || !missingOf(Role::jointVelocity, map_.velocities).empty()))
      setAside(Role::jointVelocity,
               heft::say("The joint velocities do not match the joints one by one and are ignored."));
    takeRatesOfInertialSensor();
    if (anyOf(map_.accelerometer) && !missingOf(Role::accelerometer, map_.accelerometer).empty())
      setAside(Role::accelerometer, heft::say("The accelerometer lacks an axis and is ignored."));
    if (anyOf(map_.gyroscope) && !missingOf(Role::gyroscope, map_.gyroscope).empty())
      setAside(Role::gyroscope, heft::say("The gyroscope lacks an axis and is ignored."));
    if (anyOf(map_.twist) && (!missingOf(Role::twist, map_.twist).empty() || !orientation))
      setAside(Role::twist, heft::say("The twist is incomplete or without an orientation and is ignored."));
    return std::nullopt;
  }

  /// "ax, ay, az, wx, wy, wz" without vx, vy, vz are one inertial sensor's.
  void takeRatesOfInertialSensor() {
    const auto velocity = std::span(map_.twist).first<3>();
    const auto rates = std::span(map_.twist).last<3>();
    if (!anyOf(map_.accelerometer) || anyOf(map_.gyroscope) || anyOf(velocity) || !anyOf(rates)) return;
    for (auto& column : map_.columns)
      if (column.role == Role::twist) column = {Role::gyroscope, column.index - 3};
    std::ranges::copy(rates, map_.gyroscope.begin());
    map_.twist = {};
  }

  Error missingColumns(const std::vector<std::string>& missing, const std::string& neither) const {
    std::string text;
    if (!missing.empty())
      text = missing.size() == 1 ? heft::say("column {} is missing", missing.front())
                                 : heft::say("columns {} are missing", fmt::join(missing, ", "));
    if (!neither.empty()) text += (text.empty() ? std::string() : heft::say(", and ")) + neither;
    std::vector<std::string> present;
    for (const auto& name : names_) {
      if (present.size() == 24) break;
      present.push_back(printable(name, 24));
    }
    return errorAt(at(0), text + ".",
                   heft::say("Add or rename columns; the header has: {}{}.", fmt::join(present, ", "),
                             names_.size() > present.size() ? ", ..." : ""));
  }

  void noteUnknown() {
    std::vector<std::string> unknown;
    long first = 0;
    std::size_t count = 0;
    for (std::size_t f = 0; f < names_.size(); ++f) {
      if (map_.columns[f].role != Role::extra || meaningOf(names_[f]).role != Role::extra) continue;
      if (count++ == 0) first = static_cast<long>(f) + 1;
      if (count <= 8) unknown.push_back(names_[f].empty() ? heft::say("(no name)") : printable(names_[f], 40));
    }
    if (count == 0) return;
    note(Severity::info, "unknown_columns", first,
         count == 1 ? heft::say("{} column is kept but not used: {}.", count, unknown.front())
                    : heft::say("{} columns are kept but not used: {}{}.", count, fmt::join(unknown, ", "),
                                count > unknown.size() ? ", ..." : ""));
  }

  const std::vector<std::string>& names_;
  const RecordingMeta& meta_;
  const Location& header_;
  Findings& findings_;
  ColumnMap map_;
};

}  // namespace

void ColumnMap::setAside(Role role) {
  for (auto& column : columns)
    if (column.role == role) column = {};
  switch (role) {
    case Role::time:
      time = 0;
      break;
    case Role::joint:
      joints.clear();
      break;
    case Role::jointVelocity:
      velocities.clear();
      break;
    case Role::position:
      position = {};
      break;
    case Role::quaternion:
      quaternion = {};
      break;
    case Role::twist:
      twist = {};
      break;
    case Role::accelerometer:
      accelerometer = {};
      break;
    case Role::gyroscope:
      gyroscope = {};
      break;
    case Role::wrench:
      wrench = {};
      break;
    case Role::label:
      label = 0;
      break;
    case Role::extra:
      break;
  }
}

std::string columnName(Role role, int index) {
  const auto i = static_cast<std::size_t>(index);
  switch (role) {
    case Role::time:
      return "time";
    case Role::joint:
      return fmt::format("q{}", index + 1);
    case Role::jointVelocity:
      return fmt::format("dq{}", index + 1);
    case Role::position:
      return kPosition[i];
    case Role::quaternion:
      return kQuaternion[i];
    case Role::twist:
      return kTwist[i];
    case Role::accelerometer:
      return kAccelerometer[i];
    case Role::gyroscope:
      return kGyroscope[i];
    case Role::wrench:
      return kWrench[i];
    case Role::label:
      return "label";
    case Role::extra:
      return {};
  }
  return {};
}

Result<ColumnMap> mapColumns(const std::vector<std::string>& names, const RecordingMeta& meta, const Location& header,
                             Findings& findings) {
  return Mapper(names, meta, header, findings).map();
}

}  // namespace heft
