// The committed files of the project's own Panda.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/mesh/mesh.h"
#include "core/robot/data_folder.h"
#include "core/robot/robot_model.h"
#include "resources/robots/panda/generator/panda_files.h"

namespace heft {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(HEFT_SOURCE_DIR) / "resources" / "robots" / "panda";

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

TEST(PandaFiles, areWhatTheGeneratorWrites) {
  const auto files = panda_maker::pandaFiles();
  EXPECT_EQ(files.size(), 11u);
  for (const auto& [name, content] : files) {
    // No EXPECT_EQ: it would print the bytes.
    EXPECT_TRUE(contentOf(kFolder / name) == content) << name << " is stale: run make_panda and commit what it writes.";
  }
  std::size_t meshes = 0;
  for (const auto& entry : fs::directory_iterator(kFolder / "meshes")) {
    EXPECT_TRUE(files.contains("meshes/" + entry.path().filename().string())) << entry.path() << " is made by nobody.";
    ++meshes;
  }
  EXPECT_EQ(meshes + 1, files.size());
}

TEST(PandaFiles, readWithoutAnyFinding) {
  Findings findings;
  const auto model = RobotModel::fromUrdfFile(kFolder / "panda.urdf", findings);
  ASSERT_TRUE(model) << model.error().message;
  for (const Finding& finding : findings) ADD_FAILURE() << toLine(finding);
}

TEST(PandaFiles, everyLinkHasItsMeshAndTheWholeIsSmall) {
  const RobotModel& panda = RobotModel::panda();
  std::size_t triangles = 0, bytes = 0, withMesh = 0;
  for (const Link& link : panda.links()) {
    for (const Visual& visual : link.visuals) {
      ASSERT_EQ(visual.kind, Visual::Kind::mesh);
      const Result<Mesh> mesh = loadMesh(visual.file);
      ASSERT_TRUE(mesh) << mesh.error().message;
      triangles += mesh->triangleCount();
      bytes += fs::file_size(visual.file);
      ++withMesh;
      for (const MeshPart& part : mesh->parts) {
        for (std::size_t k = 0; k < part.vertices.size(); ++k) {
          ASSERT_LT(part.vertices[k].norm(), 0.35f) << link.name;
          ASSERT_NEAR(part.normals[k].norm(), 1.0f, 1e-4f) << link.name;
        }
      }
    }
  }
  EXPECT_EQ(withMesh, 10u);  // link0 to link7, sensor, hand; link8 is only a frame
  EXPECT_LT(triangles, 62000u);
  EXPECT_LT(bytes, 1500000u);
}

TEST(PandaFiles, shellsAreWhiteAndRingsDark) {
  for (int k = 3; k <= 6; ++k) {
    const Result<Mesh> mesh = loadMesh(kFolder / "meshes" / ("link" + std::to_string(k) + ".glb"));
    ASSERT_TRUE(mesh);
    bool white = false, dark = false;
    for (const MeshPart& part : mesh->parts) {
      const float brightness = part.rgba.head<3>().mean();
      white = white || brightness > 0.85f;
      dark = dark || brightness < 0.25f;
    }
    EXPECT_TRUE(white && dark) << "link " << k;
  }
}

/// Neighbouring links must meet: the mesh of one comes within a hair of the next one's at their common seam.
TEST(PandaFiles, linksMeetWithoutGaps) {
  const RobotModel& panda = RobotModel::panda();
  std::vector<Isometry3d> X_BL;
  panda.linkPoses(panda.homePosture(), X_BL);
  const auto points = [&](const std::string& name) {
    const int link = *panda.findLink(name);
    const Visual& visual = panda.links()[link].visuals.front();
    std::vector<Vector3d> all;
    const Result<Mesh> mesh = loadMesh(visual.file);
    for (const MeshPart& part : mesh.value().parts) {
      for (const Eigen::Vector3f& v : part.vertices) all.push_back(X_BL[link] * visual.X_LV * v.cast<double>());
    }
    return all;
  };
  const std::vector<std::string> chain{"panda_link0", "panda_link1", "panda_link2", "panda_link3",  "panda_link4",
                                       "panda_link5", "panda_link6", "panda_link7", "panda_sensor", "panda_hand"};
  for (std::size_t k = 1; k < chain.size(); ++k) {
    double nearest = 1.0;
    const auto first = points(chain[k - 1]), second = points(chain[k]);
    for (const Vector3d& a : first) {
      for (const Vector3d& b : second) nearest = std::min(nearest, (a - b).squaredNorm());
    }
    EXPECT_LT(std::sqrt(nearest), 0.005) << chain[k - 1] << " and " << chain[k];
  }
}

TEST(DataFolder, environmentComesFirst) {
  ::setenv("HEFT_DATA_DIR", "/somewhere/else", 1);
  EXPECT_EQ(dataFolder(), fs::path("/somewhere/else"));
  ::setenv("HEFT_DATA_DIR", "", 1);
  EXPECT_NE(dataFolder(), fs::path(""));
  ::unsetenv("HEFT_DATA_DIR");
}

TEST(DataFolder, holdsTheRobots) { EXPECT_TRUE(fs::exists(dataFolder() / "robots" / "panda" / "panda.urdf")); }

}  // namespace
}  // namespace heft
