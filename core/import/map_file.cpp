// Map files: what the user says of topics and columns.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/mapping.h"
#include "core/import/target.h"

namespace heft {

namespace {

using nlohmann::json;

constexpr double kLargestOffset = 2e9;  ///< [s] An epoch's clock beside one that counts from power-on.

Error badMap(const std::string& name, const std::string& what) {
  return errorAt(
      {name, 0, 0}, what,
      heft::say("A map file is a JSON object with use, scale, offset_s, join, pose_of, clock, rate_hz, sensor, {}.",
                fmt::join(conventionKeys(false), ", ")));
}

}  // namespace

Result<MappingWishes> readMapFile(const std::filesystem::path& file) {
  const auto name = displayName(file);
  const auto read = readJsonFile(file);
  if (!read) return read.error();
  if (!read->is_object()) return badMap(name, heft::say("this is not a JSON object."));
  MappingWishes wishes;
  auto stated = readConventions(*read, name);
  if (!stated) return stated.error();
  wishes.conventions = std::move(*stated);
  const auto isConvention = [](const std::string& key, bool inSensor) {
    const auto keys = conventionKeys(inSensor);
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  const auto numbers = [&](const json& node, std::map<std::string, double>& out) {
    if (!node.is_object()) return false;
    for (const auto& [key, value] : node.items()) {
      if (!value.is_number() || !std::isfinite(value.get<double>())) return false;
      out[key] = value.get<double>();
    }
    return true;
  };
  for (const auto& [key, value] : read->items()) {
    if (key == "use") {
      if (!value.is_object()) return badMap(name, heft::say("\"use\" is not an object."));
      for (const auto& [target, source] : value.items()) {
        if (!source.is_string()) return badMap(name, heft::say("\"{}\" in \"use\" is not a text.", printable(target)));
        if (auto failure = checkTarget(target, name)) return *failure;
        wishes.use[target] = source.get<std::string>();
      }
    } else if (key == "scale") {
      if (!numbers(value, wishes.scale)) return badMap(name, heft::say("\"scale\" is not an object of numbers."));
      for (const auto& [target, factor] : wishes.scale) {
        if (auto failure = checkTarget(target, name)) return *failure;
        if (factor == 0.0 || (target == "time" && factor < 0.0))
          return badMap(name, heft::say("the scale of {} is {}.", target, factor));
      }
    } else if (key == "offset_s") {
      if (!numbers(value, wishes.offset)) return badMap(name, heft::say("\"offset_s\" is not an object of numbers."));
      for (const auto& [target, seconds] : wishes.offset)
        if (std::abs(seconds) > kLargestOffset)
          return errorAt(
              {name, 0, 0},
              heft::say("the offset of {} is {:g} s, more than the {:g} s (63 years) that clocks can differ by.",
                        printable(target), seconds, kLargestOffset),
              heft::say("Offsets are in seconds, even where the file counts in ms or ns."));
    } else if (key == "rate_hz") {
      if (!value.is_number() || !(value.get<double>() > 0.0) || value.get<double>() > 1e6)
        return badMap(name, heft::say("\"rate_hz\" is not a rate above 0."));
      wishes.rateHz = value.get<double>();
    } else if (key == "join") {
      if (!value.is_array()) return badMap(name, heft::say("\"join\" is not a list of files."));
      for (const auto& each : value) {
        if (!each.is_string()) return badMap(name, heft::say("\"join\" is not a list of files."));
        const std::filesystem::path other(each.get<std::string>());
        wishes.join.push_back(other.is_absolute() ? other : file.parent_path() / other);
      }
    } else if (key == "pose_of") {
      if (value != "sensor" && value != "flange")
        return badMap(name, heft::say("\"pose_of\" is neither sensor nor flange."));
      wishes.poseOfFlange = value == "flange";
    } else if (key == "clock") {
      if (value != "header" && value != "received")
        return badMap(name, heft::say("\"clock\" is neither header nor received."));
      wishes.clock = value.get<std::string>();
    } else if (key == "sensor") {
      if (!value.is_object()) return badMap(name, heft::say("\"sensor\" is not an object."));
      for (const auto& [inner, unused] : value.items())
        if (const auto path = "sensor." + printable(inner); !isConvention(inner, true))
          return badMap(name, heft::say("\"{}\" is not known.", path));
    } else if (!isConvention(key, false)) {
      return badMap(name, heft::say("\"{}\" is not known.", printable(key)));
    }
  }
  return wishes;
}

std::filesystem::path mapFileOf(const std::filesystem::path& recording) {
  auto map = recording;
  map.replace_extension();
  map += ".map.json";
  return map;
}

std::string mapText(const MappingWishes& wishes, const std::filesystem::path& folder) {
  json out = metaPatch(wishes.conventions);
  if (!wishes.use.empty()) out["use"] = wishes.use;
  if (!wishes.scale.empty()) out["scale"] = wishes.scale;
  if (!wishes.offset.empty()) out["offset_s"] = wishes.offset;
  for (const auto& file : wishes.join) {
    const auto near = file.lexically_relative(folder);
    const bool inside = !near.empty() && *near.begin() != "..";
    out["join"].push_back((inside ? near : file).string());
  }
  if (wishes.poseOfFlange) out["pose_of"] = "flange";
  if (!wishes.clock.empty()) out["clock"] = wishes.clock;
  if (wishes.rateHz > 0.0) out["rate_hz"] = wishes.rateHz;
  return out.dump(2) + "\n";
}

Result<bool> addWish(MappingWishes& wishes, const std::string& text) {
  const auto sign = text.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
    return Error{fmt::format("\"{}\" should be NAME=SOURCE, for instance wrench=/ft/raw.", printable(text))};
  const auto target = text.substr(0, sign);
  if (auto failure = checkTarget(target, "--use")) return *failure;
  wishes.use[target] = text.substr(sign + 1);
  return true;
}

}  // namespace heft
