// The sidecar NAME.meta.json: every key checked, every message with the key's path.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/recording/csv_reader.h"
#include "core/recording/robot_name.h"

namespace heft {

namespace {

using Json = nlohmann::json;

class MetaReader {
 public:
  MetaReader(const std::string& name, const std::filesystem::path& folder, Findings& findings)
      : name_(name), folder_(folder), findings_(findings) {}

  Result<RecordingMeta> read(const Json& root) {
    if (!root.is_object())
      return fail("", heft::say("a setup file must be a JSON object {{...}}"),
                  heft::say("See the keys in the manual."));
    noteUnknown(root, "",
                {"robot", "kind", "sensor", "gravity_m_s2", "known_payload", "clock_alignment_std_s", "marks", "note"},
                conventionKeys(false));
    if (auto error = readRobot(root)) return *error;
    if (auto error = readKind(root)) return *error;
    if (auto error = readSensor(root)) return *error;
    const auto stated = readConventions(root, name_);
    if (!stated) return stated.error();
    meta_.conventions = stated->values;
    if (auto error = readGravity(root)) return *error;
    if (auto error = readKnownPayload(root)) return *error;
    if (auto error = readClockAlignment(root)) return *error;
    if (auto error = readMarks(root)) return *error;
    if (auto error = readString(root, "", "note", meta_.note)) return *error;
    return std::move(meta_);
  }

 private:
  using Failure = std::optional<Error>;

  Error fail(const std::string& path, const std::string& text, const std::string& remedy = {}) const {
    return errorAt({name_, 0, 0}, (path.empty() ? "" : path + ": ") + text + ".", remedy);
  }
  void note(Severity severity, const char* code, const std::string& path, const std::string& text,
            const std::string& remedy = {}) {
    findings_.push_back({severity, code, heft::say("{}: {}.", path, text), remedy, {name_, 0, 0}});
  }

  static std::string shown(const Json& value) {
    return printable(value.dump(-1, ' ', false, Json::error_handler_t::replace), 60);
  }
  static std::string join(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
  }

  void noteUnknown(const Json& object, const std::string& path, std::initializer_list<const char*> known,
                   const std::vector<std::string>& more = {}) {
    for (const auto& [key, value] : object.items())
      if (std::find(known.begin(), known.end(), key) == known.end() &&
          std::find(more.begin(), more.end(), key) == more.end())
        note(Severity::info, "unknown_key", join(path, printable(key)),
             heft::say("this key is not known and has no effect"));
  }

  /// The member, or null if it is absent or null.
  static const Json* member(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() || found->is_null() ? nullptr : &*found;
  }

  Failure readString(const Json& object, const std::string& path, const char* key, std::string& into) {
    const auto* value = member(object, key);
    if (value == nullptr) return std::nullopt;
    if (!value->is_string()) return fail(join(path, key), heft::say("must be a text, not {}", shown(*value)));
    into = value->get<std::string>();
    return std::nullopt;
  }

  Failure readVector(const Json& object, const std::string& path, const char* key, const char* unit, Vector3d& into) {
    const auto* value = member(object, key);
    if (value == nullptr) return std::nullopt;
    const bool numbers = value->is_array() && value->size() == 3 &&
                         std::all_of(value->begin(), value->end(), [](const Json& x) { return x.is_number(); });
    if (!numbers) return fail(join(path, key), heft::say("must be three numbers [{}], not {}", unit, shown(*value)));
    for (int i = 0; i < 3; ++i) into(i) = (*value)[static_cast<std::size_t>(i)].get<double>();
    if (!into.allFinite()) return fail(join(path, key), heft::say("must be finite"));
    return std::nullopt;
  }

  Failure readRobot(const Json& root) {
    const auto* value = member(root, "robot");
    if (value == nullptr) return std::nullopt;
    if (!value->is_string() || value->get_ref<const std::string&>().empty())
      return fail("robot", heft::say("must be a text, not {}", shown(*value)),
                  heft::say("Write \"panda\", the path of a URDF, or null."));
    auto named = robotNamed(value->get_ref<const std::string&>(), folder_, name_ + ": robot");
    if (!named) return named.error();
    meta_.robot = std::move(*named);
    return std::nullopt;
  }

  Failure readKind(const Json& root) {
    const auto* value = member(root, "kind");
    if (value == nullptr) return std::nullopt;
    if (*value == "motion")
      meta_.kind = RecordingKind::motion;
    else if (*value == "poses")
      meta_.kind = RecordingKind::poses;
    else
      return fail("kind", heft::say("must be \"motion\" or \"poses\", not {}", shown(*value)));
    return std::nullopt;
  }

  Failure readSensor(const Json& root) {
    const auto* sensor = member(root, "sensor");
    if (sensor == nullptr) return std::nullopt;
    if (!sensor->is_object()) return fail("sensor", heft::say("must be an object, not {}", shown(*sensor)));
    noteUnknown(*sensor, "sensor", {"mount", "model", "wrench_sign"}, conventionKeys(true));
    if (auto error = readString(*sensor, "sensor", "model", meta_.sensorModel)) return error;
    if (const auto* sign = member(*sensor, "wrench_sign")) {
      if (*sign == "sensor_on_payload")
        meta_.wrenchSign = WrenchSign::sensorOnPayload;
      else if (*sign == "payload_on_sensor")
        meta_.wrenchSign = WrenchSign::payloadOnSensor;
      else
        return fail("sensor.wrench_sign",
                    heft::say("must be \"sensor_on_payload\" or \"payload_on_sensor\", not {}", shown(*sign)),
                    heft::say("At rest, a wrench of the sensor on the payload points up."));
    }
    const auto* mount = member(*sensor, "mount");
    if (mount == nullptr) return std::nullopt;
    const std::string path = "sensor.mount";
    if (!mount->is_object()) return fail(path, heft::say("must be an object, not {}", shown(*mount)));
    noteUnknown(*mount, path, {"parent", "xyz_m", "rpy_rad"});
    if (auto error = readString(*mount, path, "parent", meta_.mount.parent)) return error;
    if (auto error = readVector(*mount, path, "xyz_m", "m", meta_.mount.xyz)) return error;
    if (auto error = readVector(*mount, path, "rpy_rad", "rad", meta_.mount.rpy)) return error;
    if (meta_.mount.xyz.cwiseAbs().maxCoeff() > 5.0)
      return fail(path + ".xyz_m", heft::say("the sensor cannot sit {:.6g} m from its link", meta_.mount.xyz.norm()),
                  heft::say("Give metres, not millimetres."));
    if (meta_.mount.rpy.cwiseAbs().maxCoeff() > 2.0 * std::numbers::pi + 1e-6)
      return fail(path + ".rpy_rad",
                  heft::say("an angle of {:.6g} rad is more than a turn", meta_.mount.rpy.cwiseAbs().maxCoeff()),
                  heft::say("Give radians, not degrees."));
    return std::nullopt;
  }

  Failure readGravity(const Json& root) {
    const std::string key = "gravity_m_s2";
    if (auto error = readVector(root, "", key.c_str(), "m/s2", meta_.gravity)) return error;
    const double size = meta_.gravity.norm();
    if (size > 100.0)
      return fail(key, heft::say("{:.6g} m/s2 is not the gravity of any planet", size),
                  heft::say("Give m/s2; on earth about [0, 0, -9.81]."));
    if (size < 9.7 || size > 9.9)
      note(Severity::warning, "gravity_unusual", key, heft::say("{:.6g} m/s2 is not the gravity on earth", size),
           heft::say("Mass and centre of mass follow this value; on earth it is 9.76 to 9.83."));
    else if (meta_.gravity.z() > 0.5 * size)
      note(Severity::warning, "gravity_points_up", key, heft::say("it points up in the robot's base"),
           heft::say("That is right only if the robot hangs from the ceiling; otherwise write [0, 0, -9.81]."));
    return std::nullopt;
  }

  Failure readKnownPayload(const Json& root) {
    const auto* value = member(root, "known_payload");
    if (value == nullptr) return std::nullopt;
    const std::string path = "known_payload";
    if (!value->is_object()) return fail(path, heft::say("must be an object, not {}", shown(*value)));
    noteUnknown(*value, path, {"mass_kg", "com_m", "inertia_com_kgm2"});
    auto known = partialPayloadFromJson(*value, name_ + ": " + path);
    if (!known) return known.error();
    meta_.knownPayload = *known;
    if (known->mass && *known->mass > 500.0)
      note(Severity::warning, "known_mass_large", path + ".mass_kg",
           heft::say("{:.6g} kg is more than any arm carries", *known->mass), heft::say("Give kilograms, not grams."));
    if (known->com && known->com->norm() > 5.0)
      return fail(path + ".com_m",
                  heft::say("a centre of mass {:.6g} m from the sensor is not plausible", known->com->norm()),
                  heft::say("Give metres, not millimetres."));
    if (known->mass && known->com && known->inertiaCom) {
      const auto check = checkPhysical({*known->mass, *known->com, *known->inertiaCom});
      if (!check.physical)
        note(Severity::warning, "known_payload_unphysical", path,
             heft::say("no rigid body has these values ({})", check.reason),
             heft::say(
                 "Check which point and which axes the inertia refers to; Heft expects it about the centre of mass."));
    }
    return std::nullopt;
  }

  Failure readClockAlignment(const Json& root) {
    const std::string key = "clock_alignment_std_s";
    const auto* value = member(root, key.c_str());
    if (value == nullptr) return std::nullopt;
    if (!value->is_number() || !(value->get<double>() >= 0.0) || !std::isfinite(value->get<double>()))
      return fail(key, heft::say("must be a time [s], not {}", shown(*value)));
    meta_.clockAlignmentStd = value->get<double>();
    return std::nullopt;
  }

  Failure readMarks(const Json& root) {
    const auto* marks = member(root, "marks");
    if (marks == nullptr) return std::nullopt;
    if (!marks->is_array()) return fail("marks", heft::say("must be a list, not {}", shown(*marks)));
    for (std::size_t i = 0; i < marks->size(); ++i) {
      const auto& entry = (*marks)[i];
      const auto path = fmt::format("marks[{}]", i);
      const std::string remedy = heft::say("Write {{\"from_s\": 1.5, \"to_s\": 3, \"label\": \"contact\"}}.");
      if (!entry.is_object()) return fail(path, heft::say("must be an object, not {}", shown(entry)), remedy);
      noteUnknown(entry, path, {"from_s", "to_s", "label"});
      Mark mark;
      for (const auto& [key, into] : {std::pair("from_s", &mark.from), std::pair("to_s", &mark.to)}) {
        const auto* value = member(entry, key);
        if (value == nullptr) return fail(join(path, key), heft::say("is missing"), remedy);
        if (!value->is_number() || !std::isfinite(value->get<double>()))
          return fail(join(path, key), heft::say("must be a time [s], not {}", shown(*value)), remedy);
        *into = value->get<double>();
      }
      if (mark.to < mark.from)
        return fail(path, heft::say("ends at {} s, before it begins at {} s", mark.to, mark.from),
                    heft::say("Swap from_s and to_s."));
      const auto* label = member(entry, "label");
      const auto known = label != nullptr && label->is_string()
                             ? markLabelFromString(label->get_ref<const std::string&>())
                             : std::nullopt;
      if (!known)
        return fail(join(path, "label"),
                    label == nullptr ? heft::say("is missing")
                                     : heft::say("must be \"free\", \"contact\" or \"ignore\", not {}", shown(*label)),
                    remedy);
      mark.label = *known;
      for (std::size_t k = 0; k < meta_.marks.size(); ++k)
        if (meta_.marks[k].label != mark.label && mark.from < meta_.marks[k].to && meta_.marks[k].from < mark.to)
          note(Severity::warning, "marks_overlap", path, heft::say("overlaps marks[{}], which has another label", k),
               heft::say("The later mark takes precedence; correct their limits."));
      meta_.marks.push_back(mark);
    }
    return std::nullopt;
  }

  const std::string& name_;
  const std::filesystem::path& folder_;
  Findings& findings_;
  RecordingMeta meta_;
};

}  // namespace

std::filesystem::path metaFileOf(const std::filesystem::path& csv) {
  auto meta = csv;
  meta.replace_extension();
  meta += ".meta.json";
  return meta;
}

Result<RecordingMeta> parseMeta(std::string_view json, const std::string& name, const std::filesystem::path& folder,
                                Findings& findings) {
  auto parsed = parseJson(json, name);
  if (!parsed) return parsed.error();
  return MetaReader(name, folder, findings).read(*parsed);
}

Result<RecordingMeta> readMeta(const std::filesystem::path& file, Findings& findings) {
  auto text = readTextFile(file);
  if (!text) return text.error();
  return parseMeta(*text, displayName(file), file.parent_path(), findings);
}

}  // namespace heft
