#include "core/exporters/flange.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/doubts.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/payload/inertial_parameters.h"
#include "core/robot/robot_model.h"

namespace heft {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestSentence = 600;  ///< [bytes] From a file that anybody may have written

const json* member(const json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? nullptr : &*found;
}

bool isVector3(const json& list) {
  return list.is_array() && list.size() == 3 && list[0].is_number() && list[1].is_number() && list[2].is_number();
}

Result<SensorMount> readMount(const json& object, const std::string& where) {
  SensorMount mount;
  mount.parent.clear();
  if (const json* parent = member(object, "parent"); parent && parent->is_string())
    mount.parent = parent->get<std::string>();
  for (const auto& [key, target] : {std::pair{"xyz_m", &mount.xyz}, std::pair{"rpy_rad", &mount.rpy}}) {
    const json* list = member(object, key);
    if (!list) continue;
    if (!isVector3(*list)) return Error{heft::say("{}: {} of the sensor mount must be three numbers.", where, key)};
    *target = {(*list)[0].get<double>(), (*list)[1].get<double>(), (*list)[2].get<double>()};
  }
  return mount;
}

/// Pose of the mount's parent link in the flange frame; identity with a finding where it cannot be told.
Result<Isometry3d> parentInFlange(const std::string& parent, Findings& findings) {
  if (isFlangeName(parent)) return Isometry3d(Isometry3d::Identity());
  const RobotModel& panda = RobotModel::panda();
  const auto flange = panda.findLink("panda_link8");
  const auto link = panda.findLink(parent);
  if (flange && link) {
    // Only links that no joint moves against the flange may carry a sensor whose pose in F is one number.
    const VectorXd q = panda.homePosture();
    const Isometry3d X_FL = panda.linkPose(q, *flange).inverse() * panda.linkPose(q, *link);
    const VectorXd moved = panda.clampToLimits(q + VectorXd::Constant(q.size(), 0.3));
    const Isometry3d X_FL_moved = panda.linkPose(moved, *flange).inverse() * panda.linkPose(moved, *link);
    if (X_FL.isApprox(X_FL_moved, 1e-9)) return X_FL;
    return Error{heft::say("The sensor is mounted on {}, which moves against the flange: state its pose on the flange.",
                           printable(parent))};
  }
  findings.push_back({Severity::warning,
                      "flange_assumed",
                      heft::say("The sensor's parent link {} is not known to be a flange; it was taken as the flange.",
                                printable(parent)),
                      heft::say("If it is not, specify the sensor's pose on the flange."),
                      {}});
  return Isometry3d(Isometry3d::Identity());
}

const json* at(const json* list, std::initializer_list<std::size_t> path) {
  for (const std::size_t index : path) {
    if (!list || !list->is_array() || index >= list->size()) return nullptr;
    list = &(*list)[index];
  }
  return list;
}

/// Says in one warning a kind which numbers nobody measured.
void reportSources(const json& identifiability, Findings& findings) {
  constexpr std::array kAxes{"x", "y", "z"};
  std::vector<std::string> fromPrior, unknown;
  // What is doubted was measured: the finding that doubts it is passed on.
  const json* doubted = member(identifiability, "doubted");
  const auto sort = [&](const char* key, std::initializer_list<std::size_t> path, std::string name) {
    const json* const doubt = at(doubted ? member(*doubted, key) : nullptr, path);
    const json* const source = at(member(identifiability, key), path);
    if (!source || (doubt && *doubt == true)) return;
    if (*source == "prior")
      fromPrior.push_back(std::move(name));
    else if (*source == "none")
      unknown.push_back(std::move(name));
  };
  sort("mass", {}, heft::say("mass"));
  for (std::size_t i = 0; i < 3; ++i) sort("com", {i}, heft::say("centre of mass {}", kAxes[i]));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) sort("inertia", {i, j}, heft::say("inertia {}{}", kAxes[i], kAxes[j]));
  if (!unknown.empty())
    findings.push_back(
        {Severity::warning,
         "not_known",
         heft::say("Not known from this motion, so only a guess: {}.", joined(unknown)),
         heft::say(
             "Record a motion that rotates the tool faster, or specify its shape, before you rely on these values."),
         {}});
  if (!fromPrior.empty())
    findings.push_back({Severity::warning,
                        "rests_on_prior",
                        heft::say("From the shape or values that you entered, not measured: {}.", joined(fromPrior)),
                        heft::say("Check them before the robot uses them."),
                        {}});
}

std::optional<Vector6d> biasOf(const json& result) {
  const json* bias = member(result, "bias");
  const json* force = bias ? member(*bias, "force_n") : nullptr;
  const json* torque = bias ? member(*bias, "torque_nm") : nullptr;
  if (!force || !torque || !isVector3(*force) || !isVector3(*torque)) return std::nullopt;
  Vector6d out;
  for (int i = 0; i < 3; ++i) {
    out(i) = (*force)[static_cast<std::size_t>(i)].get<double>();
    out(3 + i) = (*torque)[static_cast<std::size_t>(i)].get<double>();
  }
  return out;
}

/// What the estimate itself says against its numbers.
void reportDoubts(const json& result, FlangePayload& out) {
  const json* findings = member(result, "findings");
  if (!findings || !findings->is_array()) return;
  for (const json& finding : *findings) {
    const json *severity = member(finding, "severity"), *code = member(finding, "code"),
               *text = member(finding, "text");
    if (!severity || !code || !text || !severity->is_string() || !code->is_string() || !text->is_string()) continue;
    const Severity grave = *severity == toString(Severity::info) ? Severity::info : Severity::warning;
    if (!doubtsNumbers(grave, code->get_ref<const std::string&>())) continue;
    const std::string sentence = printable(text->get<std::string>(), kLongestSentence);
    out.input.cautions.push_back(sentence);
    if (*code == "no_trust") continue;  // Said by toFlange() itself
    const json* remedy = member(finding, "remedy");
    out.findings.push_back(
        {Severity::warning,
         "doubtful",
         sentence,
         remedy && remedy->is_string() ? printable(remedy->get<std::string>(), kLongestSentence) : std::string(),
         {}});
  }
}

std::string intervalText(const json* pair, double scale, const char* unit) {
  if (!pair || !pair->is_array() || pair->size() != 2 || !(*pair)[0].is_number() || !(*pair)[1].is_number()) return "";
  const double lower = (*pair)[0].get<double>(), upper = (*pair)[1].get<double>();
  if (!std::isfinite(lower) || !std::isfinite(upper)) return "";
  return fmt::format("{:.5g} to {:.5g} {}", lower * scale, upper * scale, unit);
}

/// One line; in sensor axes, because the intervals of single numbers do not turn with the frame.
std::string uncertaintyOf(const json& result) {
  const json* interval = member(result, "interval95");
  if (!interval) return "";
  std::vector<std::string> parts;
  if (const auto text = intervalText(member(*interval, "mass_kg"), 1.0, "kg"); !text.empty())
    parts.push_back("mass " + text);
  if (const json* com = member(*interval, "com_m"); com && com->is_array() && com->size() == 3) {
    constexpr std::array kAxes{"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i)
      if (const auto text = intervalText(&(*com)[i], 1e3, "mm"); !text.empty())
        parts.push_back(fmt::format("centre {} {}", kAxes[i], text));
  }
  return parts.empty() ? "" : fmt::format("95 % intervals in sensor axes: {}", fmt::join(parts, ", "));
}

std::string provenanceOf(const json& result, const std::string& where, const FlangeOptions& options) {
  std::string text =
      fmt::format("Written by {} from {}", options.program, displayName(std::filesystem::path(where).filename()));
  if (const json* recording = member(result, "recording"))
    if (const json* file = member(*recording, "file"); file && file->is_string())
      if (const auto name = displayName(std::filesystem::path(file->get<std::string>()).filename());
          name != displayName(std::filesystem::path(where).filename()))
        text += fmt::format(", recording {}", name);
  if (const json* method = member(result, "method"); method && method->is_string())
    text += fmt::format(", method {}", method->get<std::string>());
  if (!options.addNames.empty()) text += fmt::format(", with {} added", fmt::join(options.addNames, " and "));
  return text;
}

}  // namespace

Result<SensorMount> sensorMountFromJson(const json& content, const std::string& where) {
  if (const json* sensor = member(content, "sensor"))
    if (const json* mount = member(*sensor, "mount")) return readMount(*mount, where);
  for (const char* key : {"sensor_mount", "mount"})
    if (const json* mount = member(content, key)) return readMount(*mount, where);
  if (member(content, "xyz_m")) return readMount(content, where);
  return Error{heft::say(
      "{} holds no sensor mount: expected \"sensor\": {{\"mount\": {{\"xyz_m\": [x,y,z], \"rpy_rad\": [r,p,y]}}}} "
      "as in a setup file.",
      where)};
}

Result<FlangePayload> toFlange(const json& result, const std::string& where, const FlangeOptions& options) {
  if (const json* schema = member(result, "schema");
      schema && schema->is_string() && !member(result, "payload") && !member(result, "mass_kg"))
    return Error{
        heft::say("{} is a {} file, which holds no payload; give the --json file of 'heft estimate' or the --result "
                  "file of 'heft diagnose'.",
                  where, printable(schema->get<std::string>()))};
  if (const json* trust = member(result, "trust"); trust && *trust == "none" && !options.force)
    return Error{heft::say(
        "The numbers in {} are not reliable, so no payload is written from them: see its findings first.", where)};
  FlangePayload out;
  const auto payload = payloadFromJson(result, where);
  if (!payload) return payload.error();

  SensorMount mount;
  mount.parent.clear();
  if (options.mount) {
    mount = *options.mount;
  } else if (const json* recorded = member(result, "sensor_mount")) {
    const auto read = readMount(*recorded, where);
    if (!read) return read.error();
    mount = *read;
  } else if (member(result, "identifiability") && !options.xyz) {
    out.findings.push_back(
        {Severity::warning,
         "mount_unknown",
         heft::say(
             "The result does not state where the sensor is mounted; the sensor frame was taken as the flange frame."),
         heft::say("Specify the sensor's pose on the flange."),
         {}});
  }
  if (!options.xyz || !options.rpy) {
    const auto X_FL = parentInFlange(mount.parent, out.findings);
    if (!X_FL) return X_FL.error();
    out.X_FS = *X_FL * poseFromXyzRpy(mount.xyz, mount.rpy);
    if (!options.xyz && !options.rpy && !mount.parent.empty()) out.mount = mount;
  }
  if (options.xyz) out.X_FS.translation() = *options.xyz;
  if (options.rpy) out.X_FS.linear() = rotationFromRpy(*options.rpy);

  out.input.payload = transformed(*payload, out.X_FS);
  for (const Payload& other : options.add) out.input.payload = composed(out.input.payload, other);
  if (const json* trust = member(result, "trust"); trust && *trust == "none")
    out.findings.push_back({Severity::warning,
                            "not_trusted",
                            heft::say("The estimate's own findings say that its numbers are not reliable."),
                            heft::say("Read its findings before the robot uses them."),
                            {}});
  else if (const json* identifiability = member(result, "identifiability"))
    reportSources(*identifiability, out.findings);
  if (const json* consistent = member(result, "physically_consistent"); consistent && *consistent == false)
    out.findings.push_back({Severity::warning,
                            "not_consistent",
                            heft::say("The estimate is marked as physically impossible."),
                            heft::say("Use the method map, or a longer recording that rotates the tool faster."),
                            {}});
  reportDoubts(result, out);
  for (const std::string& caution : options.cautions) {
    out.findings.push_back({Severity::warning, "doubtful", caution, {}, {}});
    out.input.cautions.push_back(caution);
  }
  out.input.X_FE = options.X_FE;
  out.input.parentLink = options.parentLink;
  out.input.sensor = SensorSide{*payload, out.X_FS, biasOf(result), options.sensorFrame};
  out.input.name = options.name;
  out.input.provenance = provenanceOf(result, where, options);
  out.input.uncertainty = uncertaintyOf(result);
  return out;
}

}  // namespace heft
