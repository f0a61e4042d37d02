#include "core/twin/found.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

using nlohmann::json;

namespace {

enum class Kind { object, list, text };

/// What a key holds that is read from a diagnosis. A part "*" of the key stands for each element.
struct Held {
  std::vector<std::string> key;
  Kind kind;
  bool needed = false;
};

const std::vector<Held>& whatIsRead() {
  static const std::vector<Held> all{{{"model"}, Kind::object, true},
                                     {{"model", "bias_and_parameters"}, Kind::list},
                                     {{"model", "terms"}, Kind::list},
                                     {{"model", "terms", "*"}, Kind::object},
                                     {{"model", "terms", "*", "cause"}, Kind::text},
                                     {{"payload_after"}, Kind::object, true},
                                     {{"causes"}, Kind::list, true},
                                     {{"causes", "*"}, Kind::object},
                                     {{"causes", "*", "cause"}, Kind::text, true},
                                     {{"causes", "*", "title"}, Kind::text},
                                     {{"causes", "*", "text"}, Kind::text},
                                     {{"causes", "*", "when"}, Kind::list},
                                     {{"causes", "*", "parameters"}, Kind::object},
                                     {{"causes", "*", "parameters", "*"}, Kind::object},
                                     {{"causes", "*", "parameters", "*", "unit"}, Kind::text},
                                     {{"smallest_visible"}, Kind::list},
                                     {{"smallest_visible", "*"}, Kind::object},
                                     {{"smallest_visible", "*", "cause"}, Kind::text},
                                     {{"smallest_visible", "*", "parameter"}, Kind::text},
                                     {{"smallest_visible", "*", "unit"}, Kind::text},
                                     {{"sensor_noise"}, Kind::object},
                                     {{"meta_changes"}, Kind::object},
                                     {{"meta_changes", "sensor"}, Kind::object},
                                     {{"meta_changes", "sensor", "mount"}, Kind::object}};
  return all;
}

bool isOf(const json& value, Kind kind) {
  return kind == Kind::object ? value.is_object() : kind == Kind::list ? value.is_array() : value.is_string();
}

/// Says which key does not hold what it should, from the part `at` of its name on; nothing where all do. `path`: what
/// `value` is called.
std::string wrongIn(const json& value, const Held& held, std::size_t at, const std::string& path) {
  if (at == held.key.size()) {
    if (isOf(value, held.kind)) return {};
    if (held.kind == Kind::object) return heft::say("{} is no object", path);
    return held.kind == Kind::list ? heft::say("{} is no list", path) : heft::say("{} is no text", path);
  }
  const std::string& part = held.key[at];
  if (part != "*") {
    const std::string name = path.empty() ? part : path + "." + part;
    // What holds it has an entry of its own.
    if (!value.is_object()) return {};
    if (value.contains(part)) return wrongIn(value[part], held, at + 1, name);
    return held.needed ? heft::say("{} is missing", name) : std::string();
  }
  for (const auto& [key, each] : value.items()) {
    if (!value.is_structured()) break;
    const std::string name = value.is_array() ? fmt::format("{}[{}]", path, key) : path + "." + printable(key);
    if (auto wrong = wrongIn(each, held, at + 1, name); !wrong.empty()) return wrong;
  }
  return {};
}

}  // namespace

const json* findCauseIn(const json& found, const std::string& id) {
  for (const auto& cause : found["causes"])
    if (cause["cause"] == id) return &cause;
  return nullptr;
}

std::optional<Error> whatIsMissing(const json& found, const std::string& where,
                                   const std::vector<std::string>& without) {
  if (!found.is_object() || found.value("schema", json()) != json("heft.diagnose/1"))
    return Error{heft::say("{} is not a result of a diagnosis; make one with heft diagnose REC --json FILE.", where)};
  for (const Held& held : whatIsRead())
    if (const std::string wrong = wrongIn(found, held, 0, {}); !wrong.empty())
      return Error{heft::say("{}: {}; make it again with heft diagnose REC --json FILE.", where, wrong)};
  for (const auto& id : without)
    if (findCauseIn(found, id) == nullptr) {
      std::vector<std::string> names;
      for (const auto& cause : found["causes"]) names.push_back(cause["cause"].get<std::string>());
      return Error{names.empty()
                       ? heft::say("{} found no cause, so {} cannot be left out.", where, printable(id))
                       : heft::say("{} did not find the cause {}; it found {}.", where, printable(id), joined(names))};
    }
  return std::nullopt;
}

}  // namespace heft
