#include "core/workspace/session.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::string_view kSchema = "heft.session/";
constexpr std::size_t kMostRecordings = 1000, kMostMarks = 100000;

std::string_view toString(ShapeChoice::Answer answer) {
  switch (answer) {
    case ShapeChoice::Answer::notGiven:
      return "not_given";
    case ShapeChoice::Answer::unknown:
      return "unknown";
    case ShapeChoice::Answer::given:
      return "given";
  }
  return {};
}

std::string_view toString(ExportChoice::Role role) {
  switch (role) {
    case ExportChoice::Role::unasked:
      return "unasked";
    case ExportChoice::Role::ownTool:
      return "own_tool";
    case ExportChoice::Role::extraLoad:
      return "extra_load";
  }
  return {};
}

/// The object that a kept text holds; empty where there is none.
json keptObject(const std::string& text) {
  json kept = json::parse(text, nullptr, false);
  return kept.is_object() ? kept : json::object();
}

/// `fresh` with the keys that only `kept` has.
json withKept(json fresh, const json& kept) {
  if (kept.is_object()) {
    for (const auto& [key, value] : kept.items())
      if (!fresh.contains(key)) fresh[key] = value;
  }
  return fresh;
}

std::string relativeTo(const fs::path& file, const fs::path& folder) {
  return displayName(folder.empty() ? file : file.lexically_proximate(folder));
}

json numberOrNull(double value) { return std::isfinite(value) ? json(value) : json(); }

json known(const PartialPayload& payload) {
  json out{{"mass_kg", json()}, {"com_m", json()}, {"inertia_com_kgm2", json()}};
  Payload all;
  if (payload.mass) all.mass = *payload.mass;
  if (payload.com) all.com = *payload.com;
  if (payload.inertiaCom) all.inertiaCom = *payload.inertiaCom;
  const json whole = toJson(all);
  if (payload.mass) out["mass_kg"] = whole.at("mass_kg");
  if (payload.com) out["com_m"] = whole.at("com_m");
  if (payload.inertiaCom) out["inertia_com_kgm2"] = whole.at("inertia_com_kgm2");
  return out;
}

json controllerJson(const ControllerChoice& choice) {
  return {{"payload", known(choice.told)},
          {"source", choice.source},
          {"collision_force_n", numberOrNull(choice.collisionForce)},
          {"collision_torque_nm", numberOrNull(choice.collisionTorque)},
          {"stiffness_n_m", numberOrNull(choice.stiffness)}};
}

json marksJson(const std::vector<Mark>& marks) {
  json out = json::array();
  for (const Mark& mark : marks)
    out.push_back({{"from_s", mark.from}, {"to_s", mark.to}, {"label", heft::toString(mark.label)}});
  return out;
}

json correctionsJson(const Corrections& corrections) {
  const json found = json::parse(corrections.found, nullptr, false);
  if (corrections.causes.empty() || !found.is_object()) return json();
  return {{"causes", corrections.causes}, {"found", found}};
}

json roomJson(const fs::path& room, const fs::path& folder) {
  if (room.empty()) return json();
  return {{"file", relativeTo(room, folder)}, {"absolute", displayName(room)}};
}

json shapeJson(const ShapeChoice& choice, const fs::path& folder) {
  Shape shape = choice.shape;
  for (ShapeBody& body : shape.bodies)
    if (body.kind == BodyKind::mesh && !folder.empty()) body.file = body.file.lexically_proximate(folder);
  return {{"answer", toString(choice.answer)},
          {"picture", choice.picture},
          {"shape", shape.bodies.empty() ? json() : toJson(shape)}};
}

// Reading: every reader says where it is, so that a damaged file is told in one sentence.

struct Reader {
  std::string name;

  Error wrong(std::string_view where, std::string_view what) const {
    return Error{heft::say("{}: \"{}\" {}. The file is damaged or was not written by Heft.", name, where, what)};
  }
};

Result<std::vector<Mark>> readMarks(const json& value, const Reader& reader) {
  std::vector<Mark> marks;
  if (value.is_null()) return marks;
  if (!value.is_array() || value.size() > kMostMarks) return reader.wrong("marks", heft::say("should be a list"));
  for (const json& entry : value) {
    const auto number = [&](const char* key) {
      return entry.is_object() && entry.contains(key) && entry[key].is_number() ? entry[key].get<double>() : NAN;
    };
    const double from = number("from_s"), to = number("to_s");
    const auto label = entry.is_object() && entry.contains("label") && entry["label"].is_string()
                           ? markLabelFromString(entry["label"].get<std::string>())
                           : std::nullopt;
    if (!std::isfinite(from) || !std::isfinite(to) || to < from || !label)
      return reader.wrong("marks", heft::say("should hold from_s, to_s and a label free, contact or ignore"));
    marks.push_back({from, to, *label});
  }
  return marks;
}

std::string textOf(const json& object, const char* key) {
  const auto it = object.find(key);
  return it != object.end() && it->is_string() ? it->get<std::string>() : std::string();
}

const json& memberOf(const json& object, const char* key) {
  static const json nothing;
  const auto it = object.find(key);
  return it == object.end() ? nothing : *it;
}

/// Keys of `object` that are not among `mine`, as JSON text; empty if there are none.
std::string othersOf(const json& object, std::initializer_list<std::string_view> mine) {
  json others = json::object();
  for (const auto& [key, value] : object.items())
    if (std::find(mine.begin(), mine.end(), key) == mine.end()) others[key] = value;
  return others.empty() ? std::string() : others.dump();
}

/// Of an object with "file" and "absolute".
fs::path fileOf(const json& entry, const fs::path& folder) {
  const fs::path relative = textOf(entry, "file");
  const fs::path file = (relative.is_absolute() ? relative : folder / relative).lexically_normal();
  std::error_code ignored;
  const std::string absolute = textOf(entry, "absolute");
  // Only the session was moved.
  return !absolute.empty() && !fs::exists(file, ignored) && fs::exists(absolute, ignored) ? fs::path(absolute) : file;
}

Result<SessionRecording> readRecordingEntry(const json& entry, const Reader& reader, const fs::path& folder) {
  if (!entry.is_object() || textOf(entry, "file").empty())
    return reader.wrong("recordings", heft::say("should name files"));
  SessionRecording out;
  out.file = fileOf(entry, folder);
  auto marks = readMarks(memberOf(entry, "marks"), reader);
  if (!marks) return marks.error();
  out.marks = std::move(marks).value();
  if (memberOf(entry, "result").is_object()) out.result = entry["result"].dump();
  const json& corrections = memberOf(entry, "corrections");
  if (corrections.is_object() && memberOf(corrections, "found").is_object() &&
      memberOf(corrections, "causes").is_array()) {
    for (const json& cause : corrections["causes"]) {
      if (!cause.is_string()) return reader.wrong("corrections", heft::say("should name causes"));
      out.corrections.causes.push_back(cause.get<std::string>());
    }
    if (!out.corrections.causes.empty()) out.corrections.found = corrections["found"].dump();
  }
  out.name = textOf(entry, "name");
  out.kept = othersOf(entry, {"file", "absolute", "name", "marks", "result", "corrections"});
  return out;
}

Result<ShapeChoice> readShapeChoice(const json& object, const Reader& reader, const fs::path& folder) {
  ShapeChoice out;
  if (!object.is_object()) return out;
  const std::string answer = textOf(object, "answer");
  for (const auto candidate : {ShapeChoice::Answer::notGiven, ShapeChoice::Answer::unknown, ShapeChoice::Answer::given})
    if (toString(candidate) == answer) out.answer = candidate;
  out.picture = textOf(object, "picture");
  if (memberOf(object, "shape").is_object()) {
    auto shape = shapeFromJson(object["shape"], reader.name + ": shape", folder);
    if (!shape) return shape.error();
    out.shape = std::move(shape).value();
  }
  if (out.shape.bodies.empty() && out.answer == ShapeChoice::Answer::given) out.answer = ShapeChoice::Answer::notGiven;
  return out;
}

Result<EstimateSettings> readSettings(const json& object, const json& knownPayload, const Reader& reader) {
  EstimateSettings out;
  if (object.is_object()) {
    if (const auto method = methodFromString(textOf(object, "method"))) out.method = *method;
    if (const auto set = parameterSetFromString(textOf(object, "parameters"))) out.parameters = *set;
    if (memberOf(object, "bias").is_boolean()) out.bias = object["bias"].get<bool>();
    if (memberOf(object, "trim").is_number()) {
      out.trim = object["trim"].get<double>();
      if (!(out.trim >= 0.0 && out.trim <= 0.45))
        return reader.wrong("trim", heft::say("should be between 0 and 0.45"));
    }
  }
  if (knownPayload.is_object()) {
    auto payload = partialPayloadFromJson(knownPayload, reader.name + ": known_payload");
    if (!payload) return payload.error();
    out.known = std::move(payload).value();
  }
  return out;
}

Result<ExportChoice> readExport(const json& object, const Reader& reader) {
  ExportChoice out;
  if (!object.is_object()) return out;
  if (const std::string format = textOf(object, "format"); !format.empty()) out.format = format;
  const std::string role = textOf(object, "role");
  for (const auto candidate : {ExportChoice::Role::unasked, ExportChoice::Role::ownTool, ExportChoice::Role::extraLoad})
    if (toString(candidate) == role) out.role = candidate;
  if (memberOf(object, "mounted_answered").is_boolean()) out.mountedAnswered = object["mounted_answered"].get<bool>();
  const json& tcp = memberOf(object, "tcp_m");
  if (!tcp.is_null()) {
    const bool three = tcp.is_array() && tcp.size() == 3 &&
                       std::all_of(tcp.begin(), tcp.end(), [](const json& each) { return each.is_number(); });
    if (!three) return reader.wrong("tcp_m", heft::say("should be three numbers"));
    out.tcp = {tcp[0].get<double>(), tcp[1].get<double>(), tcp[2].get<double>()};
  }
  const json& mounted = memberOf(object, "mounted");
  if (mounted.is_null()) return out;
  if (!mounted.is_array()) return reader.wrong("mounted", heft::say("should be a list"));
  for (const json& entry : mounted) {
    if (!entry.is_object()) return reader.wrong("mounted", heft::say("should hold a name and a payload"));
    auto payload = payloadFromJson(memberOf(entry, "payload"), reader.name + ": mounted");
    if (!payload) return payload.error();
    const json& present = memberOf(entry, "present");
    out.mounted.push_back({textOf(entry, "name"), *payload, present.is_boolean() && present.get<bool>()});
  }
  return out;
}

Result<ControllerChoice> readController(const json& object, const Reader& reader) {
  ControllerChoice out;
  if (!object.is_object()) return out;
  if (memberOf(object, "payload").is_object()) {
    auto told = partialPayloadFromJson(object["payload"], reader.name + ": controller");
    if (!told) return told.error();
    out.told = std::move(told).value();
  }
  out.source = textOf(object, "source");
  for (const auto& [key, value] :
       {std::pair{"collision_force_n", &out.collisionForce}, std::pair{"collision_torque_nm", &out.collisionTorque},
        std::pair{"stiffness_n_m", &out.stiffness}}) {
    const json& given = memberOf(object, key);
    if (given.is_null()) continue;
    if (!given.is_number() || !(given.get<double>() > 0.0))
      return reader.wrong(key, heft::say("should be a number above zero"));
    *value = given.get<double>();
  }
  return out;
}

}  // namespace

std::string sessionText(const Session& session, const fs::path& folder, bool asRecovery) {
  json recordings = json::array();
  for (const SessionRecording& recording : session.recordings) {
    const json result = json::parse(recording.result, nullptr, false);
    recordings.push_back(withKept({{"file", relativeTo(recording.file, folder)},
                                   {"absolute", displayName(recording.file)},
                                   {"name", recording.name},
                                   {"marks", marksJson(recording.marks)},
                                   {"result", result.is_object() ? result : json()},
                                   {"corrections", correctionsJson(recording.corrections)}},
                                  keptObject(recording.kept)));
  }
  json mounted = json::array();
  for (const MountedPart& part : session.exporting.mounted)
    mounted.push_back({{"name", part.name}, {"payload", toJson(part.payload)}, {"present", part.present}});
  const json kept = keptObject(session.kept), proof = json::parse(session.proof, nullptr, false);
  json view{{"step", session.step}};
  if (asRecovery) view["home"] = displayName(session.home);
  json out{{"schema", fmt::format("{}{}", kSchema, kSessionVersion)},
           {"recordings", std::move(recordings)},
           {"active", session.active},
           {"joined", session.joined},
           {"shape", withKept(shapeJson(session.shape, folder), memberOf(kept, "shape"))},
           {"settings", withKept({{"method", heft::toString(session.settings.method)},
                                  {"parameters", heft::toString(session.settings.parameters)},
                                  {"bias", session.settings.bias},
                                  {"trim", numberOrNull(session.settings.trim)}},
                                 memberOf(kept, "settings"))},
           {"known_payload", known(session.settings.known)},
           {"export",
            withKept({{"format", session.exporting.format},
                      {"role", toString(session.exporting.role)},
                      {"mounted", std::move(mounted)},
                      {"mounted_answered", session.exporting.mountedAnswered},
                      {"tcp_m", {session.exporting.tcp.x(), session.exporting.tcp.y(), session.exporting.tcp.z()}}},
                     memberOf(kept, "export"))},
           {"controller", withKept(controllerJson(session.controller), memberOf(kept, "controller"))},
           {"room", roomJson(session.room, folder)},
           {"proof", proof.is_object() ? proof : json()},
           {"view", withKept(std::move(view), memberOf(kept, "view"))}};
  return withKept(std::move(out), kept).dump(2) + "\n";
}

Result<Session> parseSession(std::string_view text, const std::string& name, const fs::path& folder) {
  auto parsed = parseJson(text, name);
  if (!parsed) return parsed.error();
  const json& object = *parsed;
  const Reader reader{name};
  const std::string schema = object.is_object() ? textOf(object, "schema") : std::string();
  if (!schema.starts_with(kSchema))
    return Error{heft::say("{} is not a session of Heft Studio: its \"schema\" should be \"{}{}\".", name, kSchema,
                           kSessionVersion)};
  int version = 0;
  for (const char c : schema.substr(kSchema.size())) {
    if (c < '0' || c > '9' || version > 100000) return reader.wrong("schema", heft::say("should end in a number"));
    version = 10 * version + (c - '0');
  }
  if (version > kSessionVersion)
    return Error{
        heft::say("{} was saved by a newer Heft (session format {}; this one reads up to {}). Update Heft to "
                  "open it; the file was not changed.",
                  name, version, kSessionVersion)};
  if (version < 1) return reader.wrong("schema", heft::say("should end in a number from 1"));

  Session out;
  const json& recordings = memberOf(object, "recordings");
  if (!recordings.is_null() && (!recordings.is_array() || recordings.size() > kMostRecordings))
    return reader.wrong("recordings", heft::say("should be a list"));
  for (const json& entry : recordings) {
    auto recording = readRecordingEntry(entry, reader, folder);
    if (!recording) return recording.error();
    out.recordings.push_back(std::move(recording).value());
  }
  const json& active = memberOf(object, "active");
  const auto count = static_cast<int>(out.recordings.size());
  out.active = active.is_number_integer() && active.get<long>() >= 0 && active.get<long>() < count
                   ? active.get<int>()
                   : (count > 0 ? 0 : -1);
  const json& joined = memberOf(object, "joined");
  out.joined = joined.is_boolean() && joined.get<bool>();
  auto shape = readShapeChoice(memberOf(object, "shape"), reader, folder);
  if (!shape) return shape.error();
  out.shape = std::move(shape).value();
  auto settings = readSettings(memberOf(object, "settings"), memberOf(object, "known_payload"), reader);
  if (!settings) return settings.error();
  out.settings = std::move(settings).value();
  auto exporting = readExport(memberOf(object, "export"), reader);
  if (!exporting) return exporting.error();
  out.exporting = std::move(exporting).value();
  auto controller = readController(memberOf(object, "controller"), reader);
  if (!controller) return controller.error();
  out.controller = std::move(controller).value();
  if (const json& room = memberOf(object, "room"); room.is_object() && !textOf(room, "file").empty())
    out.room = fileOf(room, folder);
  if (memberOf(object, "proof").is_object()) out.proof = object["proof"].dump();
  const json& view = memberOf(object, "view");
  if (view.is_object()) {
    out.step = textOf(view, "step");
    out.home = textOf(view, "home");
  }

  json kept = keptObject(othersOf(object, {"schema", "recordings", "active", "joined", "shape", "settings",
                                           "known_payload", "export", "controller", "room", "proof", "view"}));
  const auto keepInside = [&](const char* key, std::initializer_list<std::string_view> mine) {
    if (!memberOf(object, key).is_object()) return;
    const json others = keptObject(othersOf(object[key], mine));
    if (!others.empty()) kept[key] = others;
  };
  keepInside("shape", {"answer", "picture", "shape"});
  keepInside("settings", {"method", "parameters", "bias", "trim"});
  keepInside("export", {"format", "role", "mounted", "mounted_answered", "tcp_m"});
  keepInside("controller", {"payload", "source", "collision_force_n", "collision_torque_nm", "stiffness_n_m"});
  keepInside("view", {"step", "home"});
  if (!kept.empty()) out.kept = kept.dump();
  return out;
}

Result<bool> writeSession(const Session& session, const fs::path& file) {
  return writeTextFile(file, sessionText(session, fs::absolute(file).parent_path()));
}

Result<Session> readSession(const fs::path& file) {
  auto text = readTextFile(file);
  if (!text) return text.error();
  auto session = parseSession(*text, displayName(file.filename()), fs::absolute(file).parent_path());
  if (session) session->home = fs::absolute(file);
  return session;
}

EstimateOptions estimateOptions(const Session& session) {
  EstimateOptions options;
  options.method = session.settings.method;
  options.parameters = session.settings.parameters;
  options.bias = session.settings.bias;
  options.trim = session.settings.trim;
  options.known = session.settings.known;
  if (session.shape.answer == ShapeChoice::Answer::given && !session.shape.shape.bodies.empty())
    options.shape = session.shape.shape;
  return options;
}

}  // namespace heft
