#pragma once
// What stands around a robot: walls, tables, boxes and meshes in the base's axes.
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/math/rigid.h"
#include "core/mesh/mesh.h"

namespace heft {

/// A table or a wall: all behind it is closed.
struct RoomPlane {
  Vector3d point = Vector3d::Zero();    ///< On it, base axes [m]
  Vector3d normal = Vector3d::UnitZ();  ///< Towards the free side, unit length
};

/// Solid.
struct RoomBox {
  Vector3d size = Vector3d::Ones();  ///< Edges [m]
  Isometry3d X_BO = Isometry3d::Identity();
};

/// A surface: inside of a closed mesh is as free as outside, so that a cell can be one mesh.
struct RoomMesh {
  std::shared_ptr<const Mesh> mesh;
  std::string file;   ///< As stated
  double unit = 1.0;  ///< Metres a file unit
  Isometry3d X_BO = Isometry3d::Identity();
};

struct Obstacle {
  std::string name;
  std::variant<RoomPlane, RoomBox, RoomMesh> body;
};

/// Its name as it is said to a person: those that heft room gives ("table 2") in their language, others as they stand.
std::string titleOf(const Obstacle& obstacle);

struct Room {
  std::vector<Obstacle> obstacles;
  double margin = 0.02;  ///< Nothing of arm and tool comes nearer to anything [m]
};

/// {"schema": "heft.room/1", "margin_m": 0.02, "obstacles": [
///   {"name": "table", "plane": {"point_m": [x,y,z], "normal": [x,y,z]}},
///   {"name": "rack", "box": {"size_m": [x,y,z], "xyz_m": [x,y,z], "rpy_rad": [r,p,y]}},
///   {"name": "cell", "mesh": {"file": "cell.stl", "unit": "mm", "xyz_m": ..., "rpy_rad": ...}}]}
/// Relative mesh paths are taken against `folder`; `where` names the file in messages.
Result<Room> roomFromJson(const nlohmann::json& json, const std::string& where, const std::filesystem::path& folder);
nlohmann::json toJson(const Room& room);
/// Of a file; meshes beside it.
Result<Room> readRoom(const std::filesystem::path& file);

}  // namespace heft
