#include "core/import/target.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/mapping.h"

namespace heft {

namespace {

bool isColumn(const std::string& name) {
  static const std::set<std::string> kFixed = {"px", "py", "pz",     "qx",     "qy",     "qz",  "qw",
                                               "fx", "fy", "fz",     "tx",     "ty",     "tz",  "ax",
                                               "ay", "az", "imu_wx", "imu_wy", "imu_wz", "time"};
  if (kFixed.contains(name) || isRotation(name)) return true;
  const auto digits = name.starts_with("dq") ? name.substr(2) : name.starts_with("q") ? name.substr(1) : std::string();
  return !digits.empty() && digits.size() <= 2 && digits[0] != '0' &&
         digits.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

const std::vector<std::vector<std::string>>& rotationForms() {
  static const std::vector<std::vector<std::string>> kForms = {
      {"rvx", "rvy", "rvz"},
      {"kuka_a", "kuka_b", "kuka_c"},
      {"roll", "pitch", "yaw"},
      {"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"}};
  return kForms;
}

std::string partName(std::string_view part) {
  static constexpr const char* kNames[] = {
      heft::toSay("joints"),   heft::toSay("velocities"), heft::toSay("position"),      heft::toSay("quaternion"),
      heft::toSay("rotation"), heft::toSay("wrench"),     heft::toSay("accelerometer"), heft::toSay("gyroscope")};
  for (const char* const name : kNames)
    if (part == name) return heft::say(fmt::runtime(name));
  return std::string(part);
}

bool isRotation(const std::string& column) {
  const auto& forms = rotationForms();
  return std::any_of(forms.begin(), forms.end(),
                     [&](const auto& form) { return std::find(form.begin(), form.end(), column) != form.end(); });
}

std::string partOf(const std::string& column) {
  static const std::set<std::string> kQuaternion = {"qx", "qy", "qz", "qw"};
  if (kQuaternion.contains(column)) return "quaternion";
  if (isRotation(column)) return "rotation";
  if (column[0] == 'p') return "position";
  if (column[0] == 'a') return "accelerometer";
  if (column[0] == 'i') return "gyroscope";
  if (column[0] == 'd') return "velocities";
  if (column[0] == 'q') return "joints";
  return "wrench";
}

std::optional<Error> checkTarget(const std::string& name, const std::string& where) {
  const bool part = std::find(kParts.begin(), kParts.end(), name) != kParts.end();
  if (part || isColumn(name) || name == kDemonstration) return std::nullopt;
  return errorAt(
      {where, 0, 0}, heft::say("\"{}\" is not a column of a recording.", printable(name)),
      heft::say("Known are time, q1 to q7, dq1 to dq7, px, py, pz, qx, qy, qz, qw, fx, fy, fz, tx, ty, tz, ax, ay, "
                "az, and the groups joints, velocities, position, quaternion, rotation, wrench, accelerometer, "
                "gyroscope, and demo."));
}

}  // namespace heft
