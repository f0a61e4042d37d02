#include "core/twin/model_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/diagnosis/causes/ids.h"
#include "core/exporters/flange.h"
#include "core/exporters/writing.h"
#include "core/payload/inertial_parameters.h"
#include "core/recording/meta_file.h"
#include "core/twin/found.h"

namespace heft {

using nlohmann::json;
namespace ids = diagnosis::ids;

namespace {

struct NamedSize {
  std::string name, unit;
  double value = 0.0;
};

struct RigCause {
  ExportedCause told;
  std::string sentence;
  std::vector<NamedSize> sizes;
};

/// The rig as found.
struct Rig {
  Payload payload;                           ///< In S, the sensor's axes as stated
  SensorMount mount;                         ///< S as stated
  Isometry3d X_ST = Isometry3d::Identity();  ///< The sensor as found, in S
  Vector3d gravity{0.0, 0.0, -9.81};         ///< As found, base axes [m/s2]
  Vector6d bias = Vector6d::Zero();          ///< Force [N], torque [N m], sensor on payload
  Vector6d noise = Vector6d::Zero();         ///< Standard deviation from sample to sample
  double delay = 0.0, lag = 0.0;             ///< Of the readings; time constant of a first-order filter [s]
  std::vector<RigCause> causes;
  std::vector<std::string> remarks;
};

std::optional<Vector3d> vectorIn(const json& object, const char* key) {
  if (!object.is_object() || !object.contains(key)) return std::nullopt;
  const json& list = object[key];
  if (!list.is_array() || list.size() != 3 || !std::ranges::all_of(list, &json::is_number)) return std::nullopt;
  return Vector3d(list[0].get<double>(), list[1].get<double>(), list[2].get<double>());
}

/// Six numbers, forces first.
Vector6d wrenchIn(const json& object) {
  Vector6d out = Vector6d::Zero();
  if (const auto force = vectorIn(object, "force_n")) out.head<3>() = *force;
  if (const auto torque = vectorIn(object, "torque_nm")) out.tail<3>() = *torque;
  return out;
}

RigCause causeIn(const json& cause) {
  RigCause out;
  out.told.id = cause["cause"].get<std::string>();
  out.told.title = cause.value("title", out.told.id);
  out.sentence = cause.value("text", std::string());
  const json parameters = cause.value("parameters", json::object());
  for (const auto& [name, parameter] : parameters.items())
    if (parameter.contains("value") && parameter["value"].is_number())
      out.sizes.push_back({name, parameter.value("unit", std::string()), parameter["value"].get<double>()});
  return out;
}

/// Sum of the sizes of that name [ms] as seconds; a cause that was found twice has "name_2", too.
double secondsOf(const RigCause& cause, std::string_view name) {
  double sum = 0.0;
  for (const auto& size : cause.sizes)
    if (size.name.starts_with(name) && size.unit == "ms") sum += 1e-3 * size.value;
  return sum;
}

Result<Rig> rigFrom(const json& found, const std::string& where, const ModelExportOptions& options) {
  if (auto missing = whatIsMissing(found, where, options.without)) return *missing;
  Rig rig;
  const auto payload = payloadFromJson(found["payload_after"], where);
  if (!payload) return payload.error();
  rig.payload = *payload;
  if (const auto physical = checkPhysical(rig.payload); !physical.physical)
    return Error{heft::say("{}: its payload cannot exist: {}", where, physical.reason)};
  const auto stated = vectorIn(found, "gravity_m_s2");
  if (!found.contains("sensor_mount") || !stated)
    return Error{heft::say(
        "{} does not state where the sensor is mounted; make it again with heft diagnose REC --json FILE.", where)};
  auto mount = sensorMountFromJson(found, where);
  if (!mount) return mount.error();
  rig.mount = *mount;

  const auto isOff = [&](std::string_view id) { return std::ranges::count(options.without, id) > 0; };
  const json changes = found.value("meta_changes", json::object());
  const json placed = changes.value("sensor", json::object()).value("mount", json::object());
  SensorMount real = rig.mount;
  if (const auto xyz = vectorIn(placed, "xyz_m"); xyz && !isOff(ids::leverArm)) real.xyz = *xyz;
  if (const auto rpy = vectorIn(placed, "rpy_rad"); rpy && !isOff(ids::sensorRotation)) real.rpy = *rpy;
  rig.X_ST = poseFromXyzRpy(rig.mount.xyz, rig.mount.rpy).inverse() * poseFromXyzRpy(real.xyz, real.rpy);
  rig.gravity = *stated;
  if (const auto tilted = vectorIn(changes, "gravity_m_s2"); tilted && !isOff(ids::gravityTilt)) rig.gravity = *tilted;
  if (const json numbers = found["model"].value("bias_and_parameters", json::array()); numbers.size() >= 6)
    for (std::size_t i = 0; i < 6; ++i)
      if (numbers[i].is_number()) rig.bias(static_cast<Eigen::Index>(i)) = numbers[i].get<double>();
  rig.noise = wrenchIn(found.value("sensor_noise", json::object()));

  for (const auto& cause : found["causes"]) {
    RigCause next = causeIn(cause);
    if (isOff(next.told.id)) continue;
    const auto is = [&](std::string_view id) { return next.told.id == id; };
    next.told.simulated = is(ids::leverArm) || is(ids::sensorRotation) || is(ids::gravityTilt);
    if (is(ids::timeOffset)) rig.delay = secondsOf(next, "delay");
    if (is(ids::lowPassLag)) rig.lag = secondsOf(next, "time_constant");
    rig.causes.push_back(std::move(next));
  }
  rig.remarks.push_back(fmt::format("Written by {} from {}.", options.program, displayName(where)));
  if (const json verdict = found.value("verdict", json()); verdict == "unexplained")
    rig.remarks.push_back("The diagnosis left something unexplained: the rig differs from this model by that, too.");
  return rig;
}

std::vector<double> valuesOf(const RigCause& cause) {
  std::vector<double> out;
  for (const auto& size : cause.sizes) out.push_back(size.value);
  return out;
}

std::string namesOf(const RigCause& cause) {
  std::string out;
  for (const auto& size : cause.sizes) out += fmt::format("{}{} [{}]", out.empty() ? "" : ", ", size.name, size.unit);
  return out;
}

/// A remark for each cause.
std::vector<std::string> remarksAbout(const Rig& rig, std::string_view elsewhere) {
  std::vector<std::string> out = rig.remarks;
  out.emplace_back("SI units. The body carries the payload in the axes of the sensor as stated.");
  for (const auto& cause : rig.causes)
    out.push_back(cause.told.simulated ? fmt::format("{} Part of this model's geometry.", cause.sentence)
                                       : fmt::format("{} Not simulated: its sizes are in {}{}.", cause.sentence,
                                                     elsewhere, cause.told.id));
  return out;
}

std::string quaternionOf(const Matrix3d& R) {
  const Quaterniond q(R);
  return list({q.w(), q.x(), q.y(), q.z()}, " ");
}

std::string poseOf(const Isometry3d& X) {
  return list(Vector3d(X.translation()), " ") + " " + list(rpyFromRotation(X.linear()), " ");
}

std::string linkName(const SensorMount& mount) { return mount.parent.empty() ? "flange" : mount.parent; }

std::string asMjcf(const Rig& rig, const std::string& name) {
  std::vector<std::string> remarks = remarksAbout(rig, "custom/heft_");
  remarks.push_back(fmt::format(
      "Put the body {} with its site and both sensors into your robot's link {}; alone it floats on a free joint.",
      name, linkName(rig.mount)));
  remarks.emplace_back(
      "The sensors read what the sensor does to the payload, without the zero in custom/heft_zero. user: delay [s] and "
      "time constant [s] of the readings. MuJoCo adds no noise by itself.");
  std::string custom =
      fmt::format("    <numeric name=\"heft_zero\" data=\"{}\"/>\n", list(std::span(rig.bias.data(), 6), " "));
  for (const auto& cause : rig.causes)
    if (!cause.sizes.empty()) {
      const auto values = valuesOf(cause);
      custom += fmt::format(
          "    <numeric name=\"heft_{0}\" data=\"{1}\"/>\n"
          "    <text name=\"heft_{0}\" data=\"{2}\"/>\n",
          xmlEscaped(cause.told.id), list(values, " "), xmlEscaped(namesOf(cause)));
    }
  const Matrix3d& I = rig.payload.inertiaCom;
  const Isometry3d X_LS = poseFromXyzRpy(rig.mount.xyz, rig.mount.rpy);
  const auto sensor = [&](const char* kind, double noise) {
    return fmt::format("    <{0} name=\"wrist_{0}\" site=\"wrist\" noise=\"{1}\" user=\"{2} {3}\"/>\n", kind,
                       number(noise), number(rig.delay), number(rig.lag));
  };
  return xmlComment(remarks) +
         fmt::format(
             "<mujoco model=\"{0}\">\n"
             "  <compiler angle=\"radian\"/>\n"
             "  <option gravity=\"{1}\"/>\n"
             "  <size nuser_sensor=\"2\"/>\n"
             "  <custom>\n{2}  </custom>\n"
             "  <worldbody>\n"
             "    <body name=\"{3}\">\n"
             "      <freejoint/>\n"
             "      <body name=\"{0}\" pos=\"{4}\" quat=\"{5}\">\n"
             "        <inertial pos=\"{6}\" mass=\"{7}\" fullinertia=\"{8}\"/>\n"
             "        <site name=\"wrist\" pos=\"{9}\" quat=\"{10}\"/>\n"
             "      </body>\n"
             "    </body>\n"
             "  </worldbody>\n"
             "  <sensor>\n{11}{12}  </sensor>\n"
             "</mujoco>\n",
             name, list(rig.gravity, " "), custom, xmlEscaped(linkName(rig.mount)),
             list(Vector3d(X_LS.translation()), " "), quaternionOf(X_LS.linear()), list(rig.payload.com, " "),
             number(rig.payload.mass), list({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}, " "),
             list(Vector3d(rig.X_ST.translation()), " "), quaternionOf(rig.X_ST.linear()),
             sensor("force", rig.noise.head<3>().maxCoeff()), sensor("torque", rig.noise.tail<3>().maxCoeff()));
}

/// The noise of force or torque about its zero, axis by axis.
std::string sdfNoise(const Rig& rig, const char* kind, Eigen::Index first) {
  std::string out = fmt::format("            <{}>\n", kind);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    out +=
        fmt::format("              <{0}><noise type=\"gaussian\"><mean>{1}</mean><stddev>{2}</stddev></noise></{0}>\n",
                    "xyz"[axis], number(rig.bias(first + axis)), number(rig.noise(first + axis)));
  return out + fmt::format("            </{}>\n", kind);
}

std::string asSdf(const Rig& rig, const std::string& name) {
  std::vector<std::string> remarks = remarksAbout(rig, "heft:");
  remarks.emplace_back(
      "The sensor reads what it does to the payload; its zero is the noise's mean. The flange is fixed to the world: "
      "fix it to your robot's instead.");
  std::string causes;
  for (const auto& cause : rig.causes)
    for (const auto& size : cause.sizes)
      causes += fmt::format("          <heft:{0} size=\"{1}\" unit=\"{2}\">{3}</heft:{0}>\n", xmlEscaped(cause.told.id),
                            xmlEscaped(size.name), xmlEscaped(size.unit), number(size.value));
  const Matrix3d& I = rig.payload.inertiaCom;
  const Isometry3d X_LS = poseFromXyzRpy(rig.mount.xyz, rig.mount.rpy);
  const std::string link = xmlEscaped(linkName(rig.mount));
  return "<?xml version=\"1.0\"?>\n" + xmlComment(remarks) +
         fmt::format(
             "<sdf version=\"1.9\" xmlns:heft=\"urn:heft\">\n"
             "  <world name=\"rig\">\n"
             "    <gravity>{0}</gravity>\n"
             "    <model name=\"{1}_on_sensor\">\n"
             "      <joint name=\"held\" type=\"fixed\"><parent>world</parent><child>{2}</child></joint>\n"
             "      <link name=\"{2}\"/>\n"
             "      <link name=\"{1}\">\n"
             "        <pose relative_to=\"{2}\">{3}</pose>\n"
             "        <inertial>\n"
             "          <pose>{4} 0 0 0</pose>\n"
             "          <mass>{5}</mass>\n"
             "          <inertia><ixx>{6}</ixx><ixy>{7}</ixy><ixz>{8}</ixz><iyy>{9}</iyy><iyz>{10}</iyz><izz>{11}</izz>"
             "</inertia>\n"
             "        </inertial>\n"
             "      </link>\n"
             "      <joint name=\"wrist\" type=\"fixed\">\n"
             "        <parent>{2}</parent>\n"
             "        <child>{1}</child>\n"
             "        <pose>{12}</pose>\n"
             "        <sensor name=\"wrist\" type=\"force_torque\">\n"
             "          <force_torque>\n"
             "            <frame>sensor</frame>\n"
             "            <measure_direction>parent_to_child</measure_direction>\n{13}{14}"
             "          </force_torque>\n{15}"
             "        </sensor>\n"
             "      </joint>\n"
             "    </model>\n"
             "  </world>\n"
             "</sdf>\n",
             list(rig.gravity, " "), name, link, poseOf(X_LS), list(rig.payload.com, " "), number(rig.payload.mass),
             number(I(0, 0)), number(I(0, 1)), number(I(0, 2)), number(I(1, 1)), number(I(1, 2)), number(I(2, 2)),
             poseOf(rig.X_ST), sdfNoise(rig, "force", 0), sdfNoise(rig, "torque", 3), causes);
}

json listOf(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::string asJson(const Rig& rig, const std::string& name, const json& found) {
  json causes = json::array();
  for (const auto& cause : rig.causes) {
    json entry = *findCauseIn(found, cause.told.id);
    causes.push_back({{"cause", cause.told.id},
                      {"title", cause.told.title},
                      {"text", cause.sentence},
                      {"parameters", entry.value("parameters", json::object())},
                      {"when", entry.value("when", json::array())},
                      {"in_geometry", cause.told.simulated}});
  }
  json terms = json::array();
  for (const auto& term : found["model"].value("terms", json::array()))
    if (std::ranges::any_of(rig.causes, [&](const RigCause& c) { return term.value("cause", "") == c.told.id; }))
      terms.push_back(term);
  const auto wrench = [](const Vector6d& w) {
    return json{{"force_n", listOf(w.head<3>())}, {"torque_nm", listOf(w.tail<3>())}};
  };
  const json out{{"schema", "heft.model/1"},
                 {"name", name},
                 {"provenance", rig.remarks},
                 {"payload", toJson(rig.payload)},
                 {"sensor_mount", toJson(SensorMount{linkName(rig.mount), rig.mount.xyz, rig.mount.rpy})},
                 {"sensor_as_found",
                  {{"xyz_m", listOf(rig.X_ST.translation())}, {"rpy_rad", listOf(rpyFromRotation(rig.X_ST.linear()))}}},
                 {"gravity_m_s2", listOf(rig.gravity)},
                 {"zero", wrench(rig.bias)},
                 {"noise_std", wrench(rig.noise)},
                 {"delay_s", rig.delay},
                 {"time_constant_s", rig.lag},
                 {"causes", causes},
                 {"terms", terms}};
  return out.dump(2) + "\n";
}

}  // namespace

Result<ExportedModel> exportModel(const json& found, const std::string& where, ModelTarget target,
                                  const ModelExportOptions& options) {
  const auto rig = rigFrom(found, where, options);
  if (!rig) return rig.error();
  const std::string name = identifier(options.name);
  ExportedModel out;
  out.text = target == ModelTarget::mujoco   ? asMjcf(*rig, name)
             : target == ModelTarget::gazebo ? asSdf(*rig, name)
                                             : asJson(*rig, name, found);
  for (const auto& cause : rig->causes) out.causes.push_back(cause.told);
  return out;
}

}  // namespace heft
