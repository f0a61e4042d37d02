// Exported files in the readers that people use: MuJoCo for MJCF and URDF, libsdformat (Gazebo) for SDF and URDF.
#include <gtest/gtest.h>

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>

#include "core/base/json_file.h"
#include "tests/core/exporters/readers.h"

#ifdef HEFT_WITH_MUJOCO
#include <mujoco/mujoco.h>
#endif
#ifdef HEFT_WITH_SDFORMAT
#include <sdf/sdf.hh>
#endif
#ifdef HEFT_WITH_KDL_AND_DART
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/Skeleton.hpp>

#include <dart/utils/sdf/SdfParser.hpp>
#include <dart/utils/urdf/DartLoader.hpp>
#include <kdl/tree.hpp>
#include <kdl_parser/kdl_parser.hpp>
#endif

namespace heft {
namespace {

std::string fileFor(std::string_view id, const ExportInput& input) {
  Findings findings;
  return exportPayload(*findExportFormat(id), input, findings).value();
}

ExportInput inputFor(int index, const std::string& parent = {}) {
  ExportInput input;
  input.payload = randomPayload(index);
  input.name = "tool";
  input.provenance = "made by a test";
  input.parentLink = parent;
  return input;
}

/// Compares with the rounded payload, which is what stands in the file; `share`: how far inertias may differ, of the
/// largest entry.
void expectSame(const Payload& read, const Payload& payload, int index, double share = 1e-6) {
  const Payload written = roundedForExport(payload);
  const double largest = written.inertiaCom.cwiseAbs().maxCoeff();
  EXPECT_NEAR(read.mass, written.mass, 1e-9 * written.mass) << index;
  EXPECT_LT((read.com - written.com).norm(), 1e-9) << index;
  EXPECT_LT((read.inertiaCom - written.inertiaCom).cwiseAbs().maxCoeff(), share * largest) << index;
}

#if defined(HEFT_WITH_MUJOCO) || defined(HEFT_WITH_SDFORMAT) || defined(HEFT_WITH_KDL_AND_DART)
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : path_(std::filesystem::temp_directory_path() / ("heft_" + std::to_string(getpid()) + "_" + name)) {
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  std::string name() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};
#endif

#ifdef HEFT_WITH_MUJOCO
/// MuJoCo 2.3 turns a tensor into principal axes by itself: the largest difference of the 200 bodies below is 1.02e-6.
constexpr double kInMujoco = 3e-6;

/// The body "tool" of a model, about its centre of mass in the body's axes.
Payload inMujoco(const std::string& name, const std::string& text) {
  const TemporaryFile file(name, text);
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(
      mj_loadXML(file.name().c_str(), nullptr, error.data(), static_cast<int>(error.size())), mj_deleteModel);
  if (!model) throw std::runtime_error(error.data());
  const int body = mj_name2id(model.get(), mjOBJ_BODY, "tool");
  if (body < 0) return {};
  const mjtNum* q = model->body_iquat + 4 * body;
  const Matrix3d R = Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  return {model->body_mass[body], Vector3d(model->body_ipos + 3 * body),
          R * Vector3d(model->body_inertia + 3 * body).asDiagonal() * R.transpose()};
}

TEST(Mujoco, ReadsMjcfAndUrdfForTwoHundredBodies) {
  for (int index = 0; index < 200; ++index) {
    const ExportInput input = inputFor(index, "flange");
    expectSame(inMujoco("a.xml", fileFor("mjcf", input)), input.payload, index, kInMujoco);
    expectSame(inMujoco("a.urdf", fileFor("urdf", input)), input.payload, index, kInMujoco);
  }
}

TEST(Mujoco, ARootLinkWeighsNothingAsTheFileSays) {
  const ExportInput input = inputFor(4);
  const std::string text = fileFor("urdf", input);
  EXPECT_EQ(inMujoco("root.urdf", text).mass, 0.0);
  EXPECT_NE(text.find("MuJoCo give a root link no weight"), std::string::npos);
}
#else
TEST(Mujoco, ReadsMjcfAndUrdfForTwoHundredBodies) { GTEST_SKIP() << "libmujoco-dev is not installed"; }
#endif

#ifdef HEFT_WITH_SDFORMAT
/// The only link of a file's model that has a mass, in the link's axes.
Payload inSdformat(const std::string& name, const std::string& text) {
  const TemporaryFile file(name, text);
  sdf::Root root;
  for (const auto& error : root.Load(file.name())) throw std::runtime_error(error.Message());
  if (root.Model() == nullptr || root.Model()->LinkCount() != 1) throw std::runtime_error("not one link in one model");
  const auto body = root.Model()->LinkByIndex(0)->Inertial();
  const auto moi = body.Moi();
  Matrix3d I;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) I(r, c) = moi(static_cast<size_t>(r), static_cast<size_t>(c));
  const auto at = body.Pose().Pos();
  EXPECT_EQ(body.Pose().Rot().Euler().Length(), 0.0);
  return {body.MassMatrix().Mass(), {at.X(), at.Y(), at.Z()}, I};
}

TEST(Sdformat, ReadsSdfAndUrdfForTwoHundredBodies) {
  for (int index = 0; index < 200; ++index) {
    const ExportInput input = inputFor(index);
    expectSame(inSdformat("a.sdf", fileFor("sdf", input)), input.payload, index);
    expectSame(inSdformat("a.urdf", fileFor("urdf", input)), input.payload, index);
    expectSame(inSdformat("b.urdf", fileFor("urdf", inputFor(index, "flange"))), input.payload, index);
  }
}
#else
TEST(Sdformat, ReadsSdfAndUrdfForTwoHundredBodies) { GTEST_SKIP() << "libsdformat-dev is not installed"; }
#endif

#ifdef HEFT_WITH_KDL_AND_DART
/// KDL's inertia is about the segment's origin.
Payload inKdl(const std::string& text) {
  KDL::Tree tree;
  if (!kdl_parser::treeFromString(text, tree)) throw std::runtime_error("KDL takes no such URDF");
  const auto segment = tree.getSegment("tool");
  if (segment == tree.getSegments().end()) return {};
  const auto body = GetTreeElementSegment(segment->second).getInertia();
  const KDL::Vector com = body.getCOG();
  Payload out{body.getMass(), {com.x(), com.y(), com.z()}, Matrix3d::Zero()};
  const auto data = body.getRotationalInertia();
  const Matrix3d aboutOrigin = Eigen::Map<const Matrix3d>(data.data);
  const Payload point{out.mass, out.com, Matrix3d::Zero()};
  out.inertiaCom = aboutOrigin - inertiaAboutOrigin(point);
  return out;
}

TEST(Kdl, ReadsUrdfForTwoHundredBodiesBelowARootLink) {
  for (int index = 0; index < 200; ++index) {
    const ExportInput input = inputFor(index, "flange");
    expectSame(inKdl(fileFor("urdf", input)), input.payload, index);
  }
  EXPECT_EQ(inKdl(fileFor("urdf", inputFor(4))).mass, 0.0);  // a root link weighs nothing
}

Payload inDart(const dart::dynamics::SkeletonPtr& skeleton) {
  if (!skeleton || !skeleton->getBodyNode("tool")) throw std::runtime_error("DART takes no such file");
  const auto& body = skeleton->getBodyNode("tool")->getInertia();
  return {body.getMass(), body.getLocalCOM(), body.getMoment()};
}

TEST(Dart, ReadsSdfAndUrdfForTwoHundredBodies) {
  for (int index = 0; index < 200; ++index) {
    const TemporaryFile sdf("a.sdf", fileFor("sdf", inputFor(index)));
    expectSame(inDart(dart::utils::SdfParser::readSkeleton(dart::common::Uri::createFromPath(sdf.name()))),
               randomPayload(index), index);
    dart::utils::DartLoader loader;
    expectSame(inDart(loader.parseSkeletonString(fileFor("urdf", inputFor(index, "flange")), {})), randomPayload(index),
               index);
  }
}
#endif

}  // namespace
}  // namespace heft
