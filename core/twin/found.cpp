#include "core/twin/found.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

using nlohmann::json;

namespace {

/// Whether `found` is a heft.diagnose/1 as far as it is read here.
bool isDiagnosis(const json& found) {
  const auto isCause = [](const json& cause) {
    return cause.is_object() && cause.contains("cause") && cause["cause"].is_string() &&
           (!cause.contains("parameters") ||
            (cause["parameters"].is_object() && std::ranges::all_of(cause["parameters"], &json::is_object)));
  };
  return found.is_object() && found.contains("schema") && found["schema"] == "heft.diagnose/1" &&
         found.contains("model") && found.contains("payload_after") && found.contains("causes") &&
         found["causes"].is_array() && std::ranges::all_of(found["causes"], isCause);
}

}  // namespace

const json* findCauseIn(const json& found, const std::string& id) {
  for (const auto& cause : found["causes"])
    if (cause["cause"] == id) return &cause;
  return nullptr;
}

std::optional<Error> whatIsMissing(const json& found, const std::string& where,
                                   const std::vector<std::string>& without) {
  if (!isDiagnosis(found))
    return Error{heft::say("{} is not a result of a diagnosis; make one with heft diagnose REC --json FILE.", where)};
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
