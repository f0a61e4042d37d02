#include "core/recording/conventions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "core/base/findings.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/math/degrees.h"

namespace heft {

namespace {

using ConventionJson = nlohmann::json;
using ConventionPoint = Conventions::WrenchPoint;

constexpr double kPound = 4.4482216152605;  ///< [N] exactly
constexpr double kFarthestPoint = 5.0;      ///< [m]

const std::array<Conventions::Unit, 5> kForceUnits = {
    {{"N", 1.0}, {"kN", 1e3}, {"kgf", kStandardGravity}, {"lbf", kPound}, {"gf", 1e-3 * kStandardGravity}}};
const std::array<Conventions::Unit, 7> kTorqueUnits = {{{"N m", 1.0},
                                                        {"N mm", 1e-3},
                                                        {"N cm", 1e-2},
                                                        {"kgf cm", 1e-2 * kStandardGravity},
                                                        {"kgf m", kStandardGravity},
                                                        {"lbf in", 0.0254 * kPound},
                                                        {"lbf ft", 0.3048 * kPound}}};

/// A key, how its value is read (what was expected instead where it cannot be) and how it is written.
struct ConventionKey {
  const char* name;
  bool inSensor;
  std::function<std::optional<std::string>(const ConventionJson&, Conventions&)> read;
  std::function<ConventionJson(const Conventions&)> write;
};

std::string quotedWords(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? heft::say(" or ") : ", ") + ('"' + words[i] + '"');
  return out;
}

/// A key with two words; the first one is the plain form.
template <class Value>
ConventionKey twoWords(const char* name, bool inSensor, Value Conventions::*member, std::pair<const char*, Value> plain,
                       std::pair<const char*, Value> other) {
  return {name, inSensor,
          [=](const ConventionJson& value, Conventions& into) -> std::optional<std::string> {
            for (const auto& [word, meaning] : {plain, other}) {
              if (value != word) continue;
              into.*member = meaning;
              return std::nullopt;
            }
            return quotedWords({plain.first, other.first});
          },
          [=](const Conventions& from) -> ConventionJson {
            return from.*member == plain.second ? plain.first : other.first;
          }};
}

/// "N m", "Nm" and "N*m" are one unit.
std::string squeezedUnitName(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '*' && c != '.' && c != '-' && c != '_' && c != '\xC2' && c != '\xB7') out += c;
  return out;
}

ConventionKey unitKey(const char* name, Conventions::Unit Conventions::*member,
                      std::span<const Conventions::Unit> units) {
  return {name, true,
          [=](const ConventionJson& value, Conventions& into) -> std::optional<std::string> {
            if (value.is_number() && std::isfinite(value.get<double>()) && value.get<double>() > 0.0) {
              into.*member = {"", value.get<double>()};
              return std::nullopt;
            }
            std::vector<std::string> names;
            for (const auto& unit : units) {
              names.push_back(unit.name);
              if (!value.is_string() ||
                  squeezedUnitName(value.get_ref<const std::string&>()) != squeezedUnitName(unit.name))
                continue;
              into.*member = unit.si == 1.0 ? Conventions::Unit{} : unit;
              return std::nullopt;
            }
            return heft::say("{}, or a number above zero ({} in one of it)", quotedWords(names), units[0].name);
          },
          [=](const Conventions& from) -> ConventionJson {
            const auto& unit = from.*member;
            if (!unit.name.empty()) return unit.name;
            return unit.si == 1.0 ? ConventionJson(units[0].name) : ConventionJson(unit.si);
          }};
}

std::optional<std::string> readWrenchPoint(const ConventionJson& value, Conventions& into) {
  const auto isNumber = [](const ConventionJson& x) { return x.is_number() && std::isfinite(x.get<double>()); };
  if (value == "sensor" || value == "base") {
    into.wrenchPoint = {value == "base" ? ConventionPoint::Kind::base : ConventionPoint::Kind::sensor,
                        Vector3d::Zero()};
    return std::nullopt;
  }
  if (!value.is_array() || value.size() != 3 || !std::all_of(value.begin(), value.end(), isNumber))
    return heft::say("\"sensor\", \"base\" or three numbers [m] from the sensor's origin in its axes");
  const Vector3d offset(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
  if (offset.norm() > kFarthestPoint)
    return heft::say("a point within {} m of the sensor (in metres, not millimetres)", kFarthestPoint);
  into.wrenchPoint = {offset.isZero(0.0) ? ConventionPoint::Kind::sensor : ConventionPoint::Kind::offset, offset};
  return std::nullopt;
}

ConventionJson writeWrenchPoint(const Conventions& from) {
  const auto& [kind, offset] = from.wrenchPoint;
  if (kind == ConventionPoint::Kind::offset) return {offset.x(), offset.y(), offset.z()};
  return kind == ConventionPoint::Kind::base ? "base" : "sensor";
}

std::optional<std::string> readMirroredAxis(const ConventionJson& value, Conventions& into) {
  into.mirroredAxis.reset();
  if (value.is_null()) return std::nullopt;
  for (int axis = 0; axis < 3; ++axis)
    if (value == std::string(1, "xyz"[axis])) into.mirroredAxis = axis;
  if (into.mirroredAxis) return std::nullopt;
  return "null, " + quotedWords({"x", "y", "z"});
}

ConventionJson writeMirroredAxis(const Conventions& from) {
  return from.mirroredAxis ? ConventionJson(std::string(1, "xyz"[*from.mirroredAxis])) : ConventionJson();
}

const std::vector<ConventionKey>& allConventionKeys() {
  using C = Conventions;
  static const std::vector<ConventionKey> kKeys = {
      twoWords<C::WrenchAxes>("wrench_axes", true, &C::wrenchAxes, {"sensor", C::WrenchAxes::sensor},
                              {"base", C::WrenchAxes::base}),
      {"wrench_point", true, readWrenchPoint, writeWrenchPoint},
      twoWords<C::TorqueSign>("torque_sign", true, &C::torqueSign, {"as_force", C::TorqueSign::asForce},
                              {"opposite", C::TorqueSign::opposite}),
      twoWords<C::WrenchOrder>("wrench_order", true, &C::wrenchOrder, {"force_first", C::WrenchOrder::forceFirst},
                               {"torque_first", C::WrenchOrder::torqueFirst}),
      {"mirrored_axis", true, readMirroredAxis, writeMirroredAxis},
      unitKey("force_unit", &C::force, kForceUnits),
      unitKey("torque_unit", &C::torque, kTorqueUnits),
      twoWords<double>("angle_unit", false, &C::radPerAngle, {"rad", 1.0}, {"deg", kRadPerDegree}),
      twoWords<double>("length_unit", false, &C::mPerLength, {"m", 1.0}, {"mm", 1e-3}),
      twoWords<double>("acceleration_unit", false, &C::mPerS2PerAcceleration, {"m/s2", 1.0}, {"g", kStandardGravity}),
      twoWords<C::PoseDirection>("pose", false, &C::pose, {"sensor_in_base", C::PoseDirection::sensorInBase},
                                 {"base_in_sensor", C::PoseDirection::baseInSensor}),
      twoWords<C::QuaternionOrder>("quaternion_order", false, &C::quaternionOrder, {"xyzw", C::QuaternionOrder::xyzw},
                                   {"wxyz", C::QuaternionOrder::wxyz}),
  };
  return kKeys;
}

ConventionJson& placeOf(const ConventionKey& key, ConventionJson& patch) {
  return key.inSensor ? patch["sensor"][key.name] : patch[key.name];
}

}  // namespace

std::vector<std::string> conventionKeys(bool inSensor) {
  std::vector<std::string> out;
  for (const auto& key : allConventionKeys())
    if (key.inSensor == inSensor) out.emplace_back(key.name);
  return out;
}

std::span<const Conventions::Unit> forceUnits() { return kForceUnits; }
std::span<const Conventions::Unit> torqueUnits() { return kTorqueUnits; }

Result<StatedConventions> readConventions(const nlohmann::json& root, const std::string& file) {
  StatedConventions out;
  for (const auto& key : allConventionKeys()) {
    const ConventionJson* object = &root;
    if (key.inSensor) {
      const auto sensor = root.find("sensor");
      if (sensor == root.end() || !sensor->is_object()) continue;
      object = &*sensor;
    }
    const auto value = object->find(key.name);
    if (value == object->end() || (value->is_null() && std::string_view(key.name) != "mirrored_axis")) continue;
    if (const auto expected = key.read(*value, out.values))
      return errorAt(
          {file, 0, 0},
          fmt::format("{}{}: ", key.inSensor ? "sensor." : "", key.name) +
              heft::say("must be {}, not {}.", *expected,
                        printable(value->dump(-1, ' ', false, ConventionJson::error_handler_t::replace), 60)));
    out.keys.insert(key.name);
  }
  return out;
}

void takeOver(const StatedConventions& stated, Conventions& conventions) {
  for (const auto& key : allConventionKeys())
    if (stated.keys.contains(key.name)) (void)key.read(key.write(stated.values), conventions);
}

nlohmann::json toJson(const Conventions& conventions) {
  ConventionJson out = ConventionJson::object();
  for (const auto& key : allConventionKeys())
    if (auto value = key.write(conventions); value != key.write({})) out[key.name] = std::move(value);
  return out;
}

nlohmann::json metaPatch(const Conventions& conventions) { return metaPatch({}, conventions); }

nlohmann::json metaPatch(const Conventions& before, const Conventions& after) {
  ConventionJson out = ConventionJson::object();
  for (const auto& key : allConventionKeys()) {
    auto value = key.write(after);
    if (value == key.write(before)) continue;
    placeOf(key, out) = value == key.write({}) ? ConventionJson() : std::move(value);
  }
  return out;
}

nlohmann::json metaPatch(const StatedConventions& stated) {
  ConventionJson out = ConventionJson::object();
  for (const auto& key : allConventionKeys())
    if (stated.keys.contains(key.name)) placeOf(key, out) = key.write(stated.values);
  return out;
}

}  // namespace heft
