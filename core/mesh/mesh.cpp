#include "core/mesh/mesh.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>

#include "core/base/library_on_demand.h"
#include "core/base/say.h"
#include "core/base/text.h"

// Debian builds assimp with its assertions on, and on some broken files one of them ends the program. The library calls
// this function of its own by name, so that the program's definition, found first, turns them into failed loads.
namespace Assimp {
void aiAssertViolation(const char* expression, const char* file, int line);
void aiAssertViolation(const char* expression, const char* file, int line) {
  throw std::runtime_error(fmt::format("inconsistent content ({} at {}:{})", expression, file, line));
}
}  // namespace Assimp

namespace heft {
namespace {

namespace fs = std::filesystem;

// assimp's functions, which hide the declarations of its headers.
const LibraryOnDemand assimp{HEFT_ASSIMP_LIBRARY, HEFT_ASSIMP_PACKAGE};
#define HEFT_OF_ASSIMP(name) const FunctionOnDemand<decltype(::name)> name(assimp, #name)
HEFT_OF_ASSIMP(aiCreatePropertyStore);
HEFT_OF_ASSIMP(aiGetErrorString);
HEFT_OF_ASSIMP(aiGetMaterialColor);
HEFT_OF_ASSIMP(aiGetMaterialFloatArray);
HEFT_OF_ASSIMP(aiGetMaterialString);
HEFT_OF_ASSIMP(aiImportFileExWithProperties);
HEFT_OF_ASSIMP(aiIsExtensionSupported);
HEFT_OF_ASSIMP(aiReleaseImport);
HEFT_OF_ASSIMP(aiReleasePropertyStore);
HEFT_OF_ASSIMP(aiSetImportPropertyFloat);
HEFT_OF_ASSIMP(aiSetImportPropertyInteger);
#undef HEFT_OF_ASSIMP

constexpr std::uintmax_t kMaxFileBytes = 512u << 20;
constexpr unsigned kMaxNodeDepth = 200;
constexpr float kSmoothingAngleDeg = 40.0f;  ///< Facets that meet at less are shaded as one smooth surface.

std::string lowerExtension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// glTF colours are linear light; everything else, and every screen, means sRGB.
float srgbFromLinear(float x) {
  if (x <= 0.0031308f) return 12.92f * x;
  return 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

Eigen::Vector4f clamped(const aiColor4D& c) {
  const auto part = [](float x) { return std::isfinite(x) ? std::clamp(x, 0.0f, 1.0f) : 0.8f; };
  return {part(c.r), part(c.g), part(c.b), part(c.a)};
}

Eigen::Vector4f colourOf(const aiMaterial& material, bool isGltf) {
  aiString name;
  aiGetMaterialString(&material, AI_MATKEY_NAME, &name);
  if (std::string_view(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME) return MeshPart().rgba;
  aiColor4D diffuse;
  if (aiGetMaterialColor(&material, AI_MATKEY_BASE_COLOR, &diffuse) != AI_SUCCESS &&
      aiGetMaterialColor(&material, AI_MATKEY_COLOR_DIFFUSE, &diffuse) != AI_SUCCESS) {
    return MeshPart().rgba;
  }
  Eigen::Vector4f rgba = clamped(diffuse);
  if (isGltf) {
    for (int k = 0; k < 3; ++k) rgba[k] = srgbFromLinear(rgba[k]);
  }
  // COLLADA exporters write <transparency>0 for opaque bodies; nobody stores an invisible one.
  float opacity = 1.0f;
  unsigned count = 1;
  if (aiGetMaterialFloatArray(&material, AI_MATKEY_OPACITY, &opacity, &count) == AI_SUCCESS && opacity > 0.0f &&
      opacity < 1.0f)
    rgba[3] = opacity;
  if (rgba[3] <= 0.0f) rgba[3] = 1.0f;
  return rgba;
}

/// Colours per vertex (PLY) hide the material's; their mean is the part's colour.
Eigen::Vector4f meanVertexColour(const aiMesh& mesh) {
  Eigen::Vector4f sum = Eigen::Vector4f::Zero();
  for (unsigned k = 0; k < mesh.mNumVertices; ++k) sum += clamped(mesh.mColors[0][k]);
  sum /= static_cast<float>(mesh.mNumVertices);
  if (sum[3] <= 0.0f) sum[3] = 1.0f;
  return sum;
}

class Collector {
 public:
  Collector(const aiScene& scene, bool isGltf) : scene_(scene), isGltf_(isGltf) {}

  /// Empty if all went well, else what is wrong.
  std::string run(Mesh& mesh) {
    walk(*scene_.mRootNode, aiMatrix4x4(), 0);
    for (auto& [key, part] : parts_) {
      if (!part.triangles.empty()) mesh.parts.push_back(std::move(part));
    }
    if (problem_.empty() && mesh.parts.empty()) problem_ = heft::say("contains no triangle");
    return problem_;
  }

 private:
  using Key = std::array<float, 4>;

  void walk(const aiNode& node, const aiMatrix4x4& parent, unsigned depth) {
    if (depth > kMaxNodeDepth) {
      problem_ = heft::say("nests nodes deeper than {}", kMaxNodeDepth);
      return;
    }
    const aiMatrix4x4 pose = parent * node.mTransformation;
    for (unsigned k = 0; k < node.mNumMeshes && problem_.empty(); ++k) add(*scene_.mMeshes[node.mMeshes[k]], pose);
    for (unsigned k = 0; k < node.mNumChildren && problem_.empty(); ++k) walk(*node.mChildren[k], pose, depth + 1);
  }

  void add(const aiMesh& mesh, const aiMatrix4x4& pose) {
    if (!(mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE)) return;
    Eigen::Matrix4f M;
    M << pose.a1, pose.a2, pose.a3, pose.a4, pose.b1, pose.b2, pose.b3, pose.b4, pose.c1, pose.c2, pose.c3, pose.c4,
        pose.d1, pose.d2, pose.d3, pose.d4;
    const Eigen::Matrix3f linear = M.topLeftCorner<3, 3>();
    const float volume = linear.determinant();
    if (!M.allFinite() || volume == 0.0f) {
      problem_ = heft::say("places a mesh by a singular transformation");
      return;
    }
    const Eigen::Matrix3f turnNormal = linear.inverse().transpose();

    Eigen::Vector4f rgba = colourOf(*scene_.mMaterials[mesh.mMaterialIndex], isGltf_);
    if (mesh.HasVertexColors(0) && mesh.mNumVertices > 0) rgba = meanVertexColour(mesh);
    MeshPart& part = parts_[Key{rgba[0], rgba[1], rgba[2], rgba[3]}];
    part.rgba = rgba;

    const auto first = static_cast<unsigned>(part.vertices.size());
    part.vertices.reserve(first + mesh.mNumVertices);
    part.normals.reserve(first + mesh.mNumVertices);
    for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
      const aiVector3D& v = mesh.mVertices[k];
      const Eigen::Vector3f vertex = linear * Eigen::Vector3f(v.x, v.y, v.z) + M.topRightCorner<3, 1>();
      if (!vertex.allFinite()) {
        problem_ = heft::say("contains a vertex that is not a finite number");
        return;
      }
      part.vertices.push_back(vertex);
      Eigen::Vector3f normal = Eigen::Vector3f::Zero();
      if (mesh.HasNormals()) {
        const aiVector3D& n = mesh.mNormals[k];
        normal = turnNormal * Eigen::Vector3f(n.x, n.y, n.z);
      }
      const float length = normal.norm();
      part.normals.push_back(std::isfinite(length) && length > 0.0f ? (normal / length).eval()
                                                                    : Eigen::Vector3f::Zero().eval());
    }
    for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
      const aiFace& face = mesh.mFaces[k];
      if (face.mNumIndices != 3) continue;
      std::array<unsigned, 3> triangle{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
      if (*std::max_element(triangle.begin(), triangle.end()) >= mesh.mNumVertices) {
        problem_ = heft::say("has a triangle that names a vertex which does not exist");
        return;
      }
      if (volume < 0.0f) std::swap(triangle[1], triangle[2]);  // A mirror turns the surface inside out.
      for (unsigned& corner : triangle) corner += first;
      part.triangles.push_back(triangle);
      repairNormals(part, triangle);
    }
  }

  /// A vertex without a usable normal (zero or NaN in the file) takes its triangle's.
  static void repairNormals(MeshPart& part, const std::array<unsigned, 3>& triangle) {
    Eigen::Vector3f facet = (part.vertices[triangle[1]] - part.vertices[triangle[0]])
                                .cross(part.vertices[triangle[2]] - part.vertices[triangle[0]]);
    const float area = facet.norm();
    facet = area > 0.0f ? (facet / area).eval() : Eigen::Vector3f::UnitZ().eval();
    for (const unsigned corner : triangle) {
      if (part.normals[corner].isZero(0.0f)) part.normals[corner] = facet;
    }
  }

  const aiScene& scene_;
  const bool isGltf_;
  std::map<Key, MeshPart> parts_;
  std::string problem_;
};

/// assimp reads on for ever in a PLY file whose header does not end.
bool hasPlyHeader(const fs::path& file) {
  std::string head(64 << 10, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head.starts_with("ply") &&
         (head.find("\nend_header\n") != std::string::npos || head.find("\nend_header\r\n") != std::string::npos);
}

using Properties = std::unique_ptr<aiPropertyStore, void (*)(aiPropertyStore*)>;

Properties propertiesOfImport() {
  Properties properties(aiCreatePropertyStore(), aiReleasePropertyStore);
  // URDF viewers take COLLADA coordinates as they stand; <up_axis> would turn the link on its side.
  aiSetImportPropertyInteger(properties.get(), AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, 1);
  aiSetImportPropertyInteger(properties.get(), AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  aiSetImportPropertyFloat(properties.get(), AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSmoothingAngleDeg);
  aiSetImportPropertyInteger(properties.get(), AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS);
  return properties;
}

}  // namespace

std::size_t Mesh::triangleCount() const {
  std::size_t count = 0;
  for (const MeshPart& part : parts) count += part.triangles.size();
  return count;
}

Result<Mesh> loadMesh(const fs::path& file) {
  const std::string name = displayName(file);
  std::error_code problem;
  if (!fs::is_regular_file(file, problem)) return Error{heft::say("{}: There is no such mesh file.", name)};
  const std::uintmax_t bytes = fs::file_size(file, problem);
  if (problem || bytes == 0) return Error{heft::say("{}: The mesh file is empty or cannot be read.", name)};
  if (bytes > kMaxFileBytes) {
    return Error{heft::say("{}: The mesh file has {} MB; at most {} MB are read. Decimate it first.", name, bytes >> 20,
                           kMaxFileBytes >> 20)};
  }
  const std::string extension = lowerExtension(file);
  try {
    if (!aiIsExtensionSupported(extension.c_str())) {
      return Error{
          heft::say("{}: Meshes of kind \"{}\" are not known. Use .stl, .obj, .ply, .dae or .glb.", name, extension)};
    }
    if (extension == ".ply" && !hasPlyHeader(file)) {
      return Error{heft::say("{}: The mesh cannot be read: its PLY header never ends.", name)};
    }
    unsigned steps = aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType |
                     aiProcess_JoinIdenticalVertices | aiProcess_GenSmoothNormals;
    // STL stores a normal a facet, often zero: they are made afresh, smooth where the surface is.
    if (extension == ".stl") steps |= aiProcess_RemoveComponent;
    const Properties properties = propertiesOfImport();
    const std::unique_ptr<const aiScene, void (*)(const aiScene*)> scene(
        aiImportFileExWithProperties(file.string().c_str(), steps, nullptr, properties.get()), aiReleaseImport);
    if (!scene || !scene->mRootNode || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE)) {
      const std::string reason = printable(aiGetErrorString(), 200);
      return Error{
          heft::say("{}: The mesh cannot be read: {}", name, reason.empty() ? heft::say("it is incomplete.") : reason)};
    }
    Mesh mesh;
    const std::string wrong = Collector(*scene, extension == ".glb" || extension == ".gltf").run(mesh);
    if (!wrong.empty()) return Error{heft::say("{}: The mesh {}.", name, wrong)};
    return mesh;
  } catch (const std::exception& failure) {
    return Error{heft::say("{}: The mesh cannot be read: {}", name, printable(failure.what(), 200))};
  }
}

}  // namespace heft
