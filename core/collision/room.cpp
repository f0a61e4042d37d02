#include "core/collision/room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

using nlohmann::json;

namespace {

constexpr double kFarthest = 100.0;  ///< No obstacle of an arm is farther or larger [m]

/// Reads the parts of one obstacle; the first thing that is wrong stays in `error`.
class ObstacleReader {
 public:
  ObstacleReader(const json& object, std::string where) : object_(object), where_(std::move(where)) {}

  std::optional<Error> error;

  Vector3d vector(const char* key, const std::optional<Vector3d>& otherwise = std::nullopt) {
    if (!object_.contains(key) && otherwise) return *otherwise;
    const json list = object_.value(key, json());
    Vector3d out = Vector3d::Zero();
    bool good = list.is_array() && list.size() == 3;
    for (std::size_t i = 0; good && i < 3; ++i) {
      good = list[i].is_number() && std::isfinite(list[i].get<double>()) && std::abs(list[i].get<double>()) < kFarthest;
      if (good) out(static_cast<Eigen::Index>(i)) = list[i].get<double>();
    }
    if (!good && !error)
      error = Error{
          heft::say("{}: {} must be three numbers between -{:.0f} and {:.0f}.", where_, key, kFarthest, kFarthest)};
    return out;
  }
  Isometry3d pose() {
    return poseFromXyzRpy(vector("xyz_m", Vector3d(Vector3d::Zero())), vector("rpy_rad", Vector3d(Vector3d::Zero())));
  }

 private:
  const json& object_;
  std::string where_;
};

Result<RoomMesh> readMesh(const json& object, const std::string& where, const std::filesystem::path& folder) {
  RoomMesh out;
  if (!object.contains("file") || !object["file"].is_string())
    return Error{heft::say("{}: a mesh needs \"file\".", where)};
  out.file = object["file"].get<std::string>();
  const std::string unit = object.value("unit", json("m")).is_string() ? object.value("unit", "m") : "";
  constexpr std::pair<const char*, double> kUnits[] = {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}};
  const auto* found = std::ranges::find_if(kUnits, [&](const auto& u) { return unit == u.first; });
  if (found == std::end(kUnits)) return Error{heft::say("{}: the unit of a mesh is m, cm, mm or in.", where)};
  out.unit = found->second;
  ObstacleReader reader(object, where);
  out.X_BO = reader.pose();
  if (reader.error) return *reader.error;
  const std::filesystem::path file = out.file;
  auto mesh = loadMesh(file.is_absolute() ? file : folder / file);
  if (!mesh) return mesh.error();
  if (mesh->triangleCount() == 0) return Error{heft::say("{}: {} holds no triangle.", where, printable(out.file))};
  out.mesh = std::make_shared<const Mesh>(std::move(mesh).value());
  return out;
}

Result<Obstacle> readObstacle(const json& object, const std::string& where, const std::filesystem::path& folder) {
  Obstacle out;
  if (!object.is_object()) return Error{heft::say("{} is not an object.", where)};
  out.name = object.value("name", json()).is_string() ? printable(object["name"].get<std::string>()) : "";
  if (out.name.empty()) return Error{heft::say("{} needs a \"name\", by which it is called in messages.", where)};
  std::vector<std::string> kinds;
  for (const char* kind : {"plane", "box", "mesh"})
    if (object.contains(kind) && object[kind].is_object()) kinds.emplace_back(kind);
  if (kinds.size() != 1)
    return Error{heft::say("{} ({}) must be one of \"plane\", \"box\" and \"mesh\".", where, out.name)};
  const json& body = object[kinds.front()];
  if (kinds.front() == "mesh") {
    auto mesh = readMesh(body, where, folder);
    if (!mesh) return mesh.error();
    out.body = std::move(*mesh);
    return out;
  }
  ObstacleReader reader(body, where);
  if (kinds.front() == "plane") {
    RoomPlane plane{reader.vector("point_m"), reader.vector("normal")};
    if (!reader.error && !(plane.normal.norm() > 1e-6))
      return Error{heft::say("{}: the normal vector is zero.", where)};
    plane.normal.normalize();
    out.body = plane;
  } else {
    RoomBox box{reader.vector("size_m"), reader.pose()};
    if (!reader.error && !(box.size.minCoeff() > 0.0))
      return Error{heft::say("{}: the edges of a box must be above zero.", where)};
    out.body = box;
  }
  if (reader.error) return *reader.error;
  return out;
}

json listOf(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

std::string titleOf(const Obstacle& obstacle) {
  constexpr std::array kinds{std::pair<std::string_view, const char*>{"table", toSay("table")},
                             std::pair<std::string_view, const char*>{"wall", toSay("wall")},
                             std::pair<std::string_view, const char*>{"ceiling", toSay("ceiling")}};
  const std::string_view name = obstacle.name;
  for (const auto& [kind, said] : kinds) {
    if (!name.starts_with(kind)) continue;
    const std::string_view number = name.substr(kind.size());
    const bool numbered = number.size() > 1 && number.front() == ' ' &&
                          number.find_first_not_of("0123456789", 1) == std::string_view::npos;
    if (number.empty() || numbered) return heft::say(fmt::runtime(said)) + std::string(number);
  }
  return obstacle.name;
}

Result<Room> roomFromJson(const json& content, const std::string& where, const std::filesystem::path& folder) {
  if (!content.is_object() || content.value("schema", json()) != "heft.room/1" || !content.contains("obstacles") ||
      !content["obstacles"].is_array())
    return Error{heft::say("{} is not a room: expected {{\"schema\": \"heft.room/1\", \"obstacles\": [...]}}.", where)};
  Room room;
  if (content.contains("margin_m")) {
    const json& margin = content["margin_m"];
    if (!margin.is_number() || !(margin.get<double>() >= 0.0 && margin.get<double>() <= 0.5))
      return Error{heft::say("{}: margin_m must be a number from 0 to 0.5.", where)};
    room.margin = margin.get<double>();
  }
  for (std::size_t i = 0; i < content["obstacles"].size(); ++i) {
    auto obstacle = readObstacle(content["obstacles"][i], heft::say("{}, obstacle {}", where, i + 1), folder);
    if (!obstacle) return obstacle.error();
    const bool known = std::ranges::any_of(room.obstacles, [&](const Obstacle& o) { return o.name == obstacle->name; });
    if (known) return Error{heft::say("{}: two obstacles are called {}.", where, obstacle->name)};
    room.obstacles.push_back(std::move(*obstacle));
  }
  return room;
}

Result<Room> readRoom(const std::filesystem::path& file) {
  const auto content = readJsonFile(file);
  if (!content) return content.error();
  return roomFromJson(*content, displayName(file), file.parent_path());
}

json toJson(const Room& room) {
  json obstacles = json::array();
  for (const auto& obstacle : room.obstacles) {
    json entry{{"name", obstacle.name}};
    if (const auto* plane = std::get_if<RoomPlane>(&obstacle.body)) {
      entry["plane"] = {{"point_m", listOf(plane->point)}, {"normal", listOf(plane->normal)}};
    } else if (const auto* box = std::get_if<RoomBox>(&obstacle.body)) {
      entry["box"] = {{"size_m", listOf(box->size)},
                      {"xyz_m", listOf(box->X_BO.translation())},
                      {"rpy_rad", listOf(rpyFromRotation(box->X_BO.linear()))}};
    } else {
      const auto& mesh = std::get<RoomMesh>(obstacle.body);
      const char* unit = mesh.unit == 1.0 ? "m" : mesh.unit == 0.01 ? "cm" : mesh.unit == 0.001 ? "mm" : "in";
      entry["mesh"] = {{"file", mesh.file},
                       {"unit", unit},
                       {"xyz_m", listOf(mesh.X_BO.translation())},
                       {"rpy_rad", listOf(rpyFromRotation(mesh.X_BO.linear()))}};
    }
    obstacles.push_back(std::move(entry));
  }
  return {{"schema", "heft.room/1"}, {"margin_m", room.margin}, {"obstacles", obstacles}};
}

}  // namespace heft
