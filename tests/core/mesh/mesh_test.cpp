#include "core/mesh/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace heft {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A folder of its own for each test, removed afterwards.
class MeshFile : public ::testing::Test {
 protected:
  MeshFile() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("heft_mesh_" + std::string(info->name()) + "_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  ~MeshFile() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  Mesh load(const std::string& name, const std::string& content) const {
    Result<Mesh> mesh = loadMesh(write(name, content));
    if (!mesh) {
      ADD_FAILURE() << mesh.error().message;
      return {};
    }
    return std::move(mesh).value();
  }
  std::string failure(const std::string& name, const std::string& content) const {
    const Result<Mesh> mesh = loadMesh(write(name, content));
    return mesh ? "" : mesh.error().message;
  }

  fs::path folder_;
};

template <class T>
void put(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

struct Bounds {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9f), high = Eigen::Vector3f::Constant(-1e9f);
};

Bounds boundsOf(const Mesh& mesh) {
  Bounds bounds;
  for (const MeshPart& part : mesh.parts) {
    for (const Eigen::Vector3f& v : part.vertices) {
      bounds.low = bounds.low.cwiseMin(v);
      bounds.high = bounds.high.cwiseMax(v);
    }
  }
  return bounds;
}

/// What every loaded mesh must fulfil.
void expectSound(const Mesh& mesh) {
  ASSERT_FALSE(mesh.parts.empty());
  for (const MeshPart& part : mesh.parts) {
    ASSERT_EQ(part.vertices.size(), part.normals.size());
    ASSERT_FALSE(part.triangles.empty());
    for (const Eigen::Vector3f& normal : part.normals) ASSERT_NEAR(normal.norm(), 1.0f, 1e-4f);
    for (const auto& triangle : part.triangles) {
      for (const unsigned corner : triangle) ASSERT_LT(corner, part.vertices.size());
    }
    EXPECT_GT(part.rgba[3], 0.0f);
    EXPECT_LE(part.rgba.maxCoeff(), 1.0f);
  }
}

/// Normals and triangles must agree about where outside is.
void expectOutwards(const Mesh& mesh) {
  for (const MeshPart& part : mesh.parts) {
    for (const auto& t : part.triangles) {
      const Eigen::Vector3f facet =
          (part.vertices[t[1]] - part.vertices[t[0]]).cross(part.vertices[t[2]] - part.vertices[t[0]]);
      EXPECT_GT(facet.dot(part.normals[t[0]]), 0.0f);
    }
  }
}

// A triangle (0 0 0) (2 0 0) (0 1 0) in all formats; its normal is z.

std::string asciiStl() {
  return "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 "
         "0\nendloop\nendfacet\nendsolid t\n";
}

/// Its stored facet normal is zero, as many programs write it.
std::string binaryStl(std::uint32_t claimed = 1) {
  std::string out(80, ' ');
  put(out, claimed);
  for (const float x : {0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 1, 0}) put(out, x);
  put(out, std::uint16_t{0});
  return out;
}

std::string obj() { return "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n"; }

std::string ply() {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 51\n2 0 0 255 0 51\n0 1 0 255 0 51\n3 0 1 "
         "2\n";
}

/// y up, millimetres, a node that shifts, opacity by <transparency>0: all the traps of the format at once.
std::string dae(const std::string& position = "0 0 0 2000 0 0 0 1000 0") {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="millimeter" meter="0.001"/><up_axis>Y_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="c"><lambert>
<diffuse><color>0.25 0.5 0.75 1</color></diffuse><transparent opaque="RGB_ZERO"><color>1 1 1 1</color></transparent>
<transparency><float>0</float></transparency></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">)" +
         position + R"(</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="mm" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><translate>0 0 500</translate><instance_geometry url="#g">
<bind_material><technique_common><instance_material symbol="mm" target="#m"/></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// `node` is put into the node, for instance a scale.
std::string glb(const std::string& node = R"("translation":[1,2,3])", const std::string& indices = "VEC3") {
  std::string data;
  for (const float x : {0, 0, 0, 2, 0, 0, 0, 1, 0}) put(data, x);
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,)" + node +
      R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],"materials":[{"pbrMetallicRoughness":)"
      R"({"baseColorFactor":[0.2140411,0,1,1]}}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":")" +
      indices +
      R"(","min":[0,0,0],"max":[2,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
      R"("buffers":[{"byteLength":36}]})";
  while (json.size() % 4) json += ' ';
  std::string out = "glTF";
  put(out, std::uint32_t{2});
  put(out, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + data.size()));
  put(out, static_cast<std::uint32_t>(json.size()));
  out += "JSON" + json;
  put(out, static_cast<std::uint32_t>(data.size()));
  return out + std::string("BIN\0", 4) + data;
}

void expectTriangle(const Mesh& mesh, const Eigen::Vector3f& at = Eigen::Vector3f::Zero()) {
  expectSound(mesh);
  expectOutwards(mesh);
  EXPECT_EQ(mesh.triangleCount(), 1u);
  const Bounds bounds = boundsOf(mesh);
  EXPECT_LT((bounds.low - at).norm(), 1e-5f);
  EXPECT_LT((bounds.high - at - Eigen::Vector3f(2, 1, 0)).norm(), 1e-5f);
  EXPECT_NEAR(mesh.parts[0].normals[0].z(), 1.0f, 1e-5f);
}

TEST_F(MeshFile, stlAsText) { expectTriangle(load("t.stl", asciiStl())); }

TEST_F(MeshFile, stlBinaryWithZeroNormals) {
  const Mesh mesh = load("t.STL", binaryStl());
  expectTriangle(mesh);
  EXPECT_EQ(mesh.parts[0].rgba, MeshPart().rgba);  // It has no colour of its own.
}

TEST_F(MeshFile, obj) { expectTriangle(load("t.obj", obj())); }

TEST_F(MeshFile, objWithMaterials) {
  write("t.mtl", "newmtl red\nKd 0.8 0.1 0.2\nnewmtl glass\nKd 0 0 1\nd 0.4\n");
  const Mesh mesh =
      load("t.obj", "mtllib t.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl glass\nf 1 3 2\n");
  ASSERT_EQ(mesh.parts.size(), 2u);
  const bool firstIsRed = mesh.parts[0].rgba[0] > 0.5f;
  EXPECT_LT((mesh.parts[firstIsRed ? 0 : 1].rgba - Eigen::Vector4f(0.8f, 0.1f, 0.2f, 1.0f)).norm(), 1e-5f);
  EXPECT_LT((mesh.parts[firstIsRed ? 1 : 0].rgba - Eigen::Vector4f(0.0f, 0.0f, 1.0f, 0.4f)).norm(), 1e-5f);
}

TEST_F(MeshFile, plyWithVertexColours) {
  const Mesh mesh = load("t.ply", ply());
  expectTriangle(mesh);
  EXPECT_LT((mesh.parts[0].rgba - Eigen::Vector4f(1.0f, 0.0f, 0.2f, 1.0f)).norm(), 1e-2f);
}

TEST_F(MeshFile, colladaKeepsItsAxesAndAppliesUnitAndNodes) {
  const Mesh mesh = load("t.dae", dae());
  expectTriangle(mesh, {0.0f, 0.0f, 0.5f});
  EXPECT_LT((mesh.parts[0].rgba - Eigen::Vector4f(0.25f, 0.5f, 0.75f, 1.0f)).norm(), 1e-5f);
}

TEST_F(MeshFile, glbAppliesNodesAndShowsColoursAsTheyLook) {
  const Mesh mesh = load("t.glb", glb());
  expectTriangle(mesh, {1.0f, 2.0f, 3.0f});
  EXPECT_LT((mesh.parts[0].rgba - Eigen::Vector4f(0.5f, 0.0f, 1.0f, 1.0f)).norm(), 1e-3f);
}

TEST_F(MeshFile, mirroredNodeKeepsTheOutsideOutside) {
  const Mesh mesh = load("t.glb", glb(R"("scale":[-1,1,1])"));
  expectSound(mesh);
  expectOutwards(mesh);
  EXPECT_NEAR(boundsOf(mesh).low.x(), -2.0f, 1e-6f);
}

TEST_F(MeshFile, smoothSurfacesOfStlAreShadedSmoothAndEdgesStay) {
  // A prism of 24 sides: its side is smooth, its ends meet it at a right angle.
  std::string text = "solid p\n";
  const auto facet = [&](const std::array<Eigen::Vector3f, 3>& corners) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const auto& c : corners) {
      text += "vertex " + std::to_string(c.x()) + " " + std::to_string(c.y()) + " " + std::to_string(c.z()) + "\n";
    }
    text += "endloop\nendfacet\n";
  };
  const auto rim = [](int k, float z) {
    const float angle = 6.2831853f * static_cast<float>(k % 24) / 24.0f;
    return Eigen::Vector3f(std::cos(angle), std::sin(angle), z);
  };
  for (int k = 0; k < 24; ++k) {
    facet({rim(k, 0), rim(k + 1, 0), rim(k + 1, 1)});
    facet({rim(k, 0), rim(k + 1, 1), rim(k, 1)});
    facet({Eigen::Vector3f(0, 0, 1), rim(k, 1), rim(k + 1, 1)});
  }
  const Mesh mesh = load("p.stl", text + "endsolid p\n");
  expectSound(mesh);
  for (std::size_t k = 0; k < mesh.parts[0].vertices.size(); ++k) {
    const Eigen::Vector3f& normal = mesh.parts[0].normals[k];
    if (std::abs(normal.z()) > 0.5f) {
      EXPECT_NEAR(normal.z(), 1.0f, 1e-3f);
    } else {
      const Eigen::Vector3f vertex = mesh.parts[0].vertices[k];
      const Eigen::Vector3f radial = Eigen::Vector3f(vertex.x(), vertex.y(), 0).normalized();
      EXPECT_GT(normal.dot(radial), 0.995f);
    }
  }
}

TEST_F(MeshFile, brokenFilesAreRefusedWithASentence) {
  const struct {
    const char* name;
    std::string content;
  } broken[] = {
      {"empty.stl", ""},
      {"short.stl", binaryStl().substr(0, 90)},
      {"claims.stl", binaryStl(1000000)},
      {"noise.stl", std::string(300, '\x81')},
      {"nan.stl",
       "solid t\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex 2 0 0\nvertex 0 1 "
       "0\nendloop\nendfacet\nendsolid t\n"},
      {"points.obj", "v 0 0 0\nv 1 0 0\n"},
      {"range.obj", "v 0 0 0\nv 2 0 0\nf 1 2 9\n"},
      {"noise.obj", std::string(300, '\x81')},
      {"cut.ply", ply().substr(0, 250)},
      {"range.ply", ply().substr(0, ply().size() - 8) + "3 0 1 77\n"},
      {"head.ply", "ply\nformat ascii 1.0\n"},
      {"cut.dae", dae().substr(0, 900)},
      {"other.dae", "<html/>"},
      {"words.dae", dae("0 0 0 one two three 0 1 0")},
      {"cut.glb", glb().substr(0, 60)},
      {"magic.glb", "glTX" + glb().substr(4)},
      {"json.glb", glb("\"translation\":[1,2")},
      {"singular.glb", glb(R"("scale":[0,1,1])")},
  };
  for (const auto& file : broken) {
    const std::string message = failure(file.name, file.content);
    EXPECT_THAT(message, AllOf(HasSubstr(file.name), HasSubstr(": "))) << file.name;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LT(message.size(), 500u);
  }
}

TEST_F(MeshFile, namesWhatIsMissingOrUnknown) {
  const Result<Mesh> missing = loadMesh(folder_ / "none.stl");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("no such mesh file"));
  EXPECT_THAT(failure("mesh.docx", "x"), HasSubstr("\".docx\" are not known"));
  EXPECT_THAT(failure("mesh", "x"), HasSubstr("are not known"));
  const Result<Mesh> folder = loadMesh(folder_);
  EXPECT_FALSE(folder);
}

TEST(FrankaDescription, everyMeshLoads) {
  const char* given = std::getenv("HEFT_SHARED");
  const fs::path shared = given ? fs::path(given) : fs::path(HEFT_SOURCE_DIR) / ".." / "shared";
  const fs::path meshes = shared / "franka_description" / "meshes";
  if (!fs::exists(meshes)) GTEST_SKIP() << "no franka_description beside the project";
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(meshes)) {
    if (!entry.is_regular_file()) continue;
    const Result<Mesh> mesh = loadMesh(entry.path());
    ASSERT_TRUE(mesh) << mesh.error().message;
    expectSound(*mesh);
    const Bounds bounds = boundsOf(*mesh);
    const float size = (bounds.high - bounds.low).maxCoeff();
    EXPECT_GT(size, 0.02f) << entry.path();  // Metres: neither millimetres nor inches.
    EXPECT_LT(size, 0.40f) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 19);
}

}  // namespace
}  // namespace heft
