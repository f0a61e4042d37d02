#pragma once
// Triangle meshes of any format that assimp reads (.dae .stl .obj .ply .glb ...), as plain data.
#include <array>
#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/math/rigid.h"

namespace heft {

struct MeshPart {
  std::vector<Eigen::Vector3f> vertices;  ///< [m] once scaled, in the mesh frame
  std::vector<Eigen::Vector3f> normals;   ///< One per vertex, unit length
  std::vector<std::array<unsigned, 3>> triangles;
  Eigen::Vector4f rgba{0.8f, 0.8f, 0.8f, 1.0f};
};

struct Mesh {
  std::vector<MeshPart> parts;  ///< One a material.
  std::size_t triangleCount() const;
};

/// Loads a mesh with the file's own unit and node transforms applied (COLLADA up-axis ignored, as ROS does).
Result<Mesh> loadMesh(const std::filesystem::path& file);

}  // namespace heft
