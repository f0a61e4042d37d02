// Volume integrals of meshes, their repair, and the points inside them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/payload/mesh_volume.h"
#include "core/payload/shape.h"
#include "core/payload/shape_moments.h"

namespace heft {
namespace {

using ::testing::HasSubstr;

/// Unshared vertices, as an STL file has them.
void addTriangle(Mesh& mesh, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  if (mesh.parts.empty()) mesh.parts.emplace_back();
  MeshPart& part = mesh.parts.back();
  const auto first = static_cast<unsigned>(part.vertices.size());
  for (const Vector3d& v : {a, b, c}) part.vertices.push_back(v.cast<float>());
  part.triangles.push_back({first, first + 1, first + 2});
}

/// Box with `cells` squares along each edge, counter-clockwise seen from outside.
void addBox(Mesh& mesh, const Vector3d& center, const Vector3d& size, int cells = 1, bool inward = false) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5})
      for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k) {
          const auto at = [&](int di, int dk) {
            Vector3d u = Vector3d::Zero();
            u[axis] = side;
            u[(axis + 1) % 3] = static_cast<double>(i + di) / cells - 0.5;
            u[(axis + 2) % 3] = static_cast<double>(k + dk) / cells - 0.5;
            return Vector3d(center + size.cwiseProduct(u));
          };
          const bool flip = (side < 0) != inward;
          const Vector3d a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
          addTriangle(mesh, a, flip ? c : b, flip ? b : c);
          addTriangle(mesh, a, flip ? d : c, flip ? c : d);
        }
}

Mesh boxMesh(const Vector3d& center, const Vector3d& size, int cells = 1) {
  Mesh mesh;
  addBox(mesh, center, size, cells);
  return mesh;
}

/// Surface of revolution about z through (radius, z), closed if it starts and ends on the axis.
Mesh turned(const std::vector<Eigen::Vector2d>& profile, int sides) {
  Mesh mesh;
  const auto at = [&](std::size_t i, int k) {
    const double angle = 2 * std::numbers::pi * (k % sides) / sides;
    return Vector3d(profile[i].x() * std::cos(angle), profile[i].x() * std::sin(angle), profile[i].y());
  };
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    for (int k = 0; k < sides; ++k) {
      if (profile[i].x() > 0) addTriangle(mesh, at(i, k), at(i, k + 1), at(i + 1, k));
      if (profile[i + 1].x() > 0) addTriangle(mesh, at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
    }
  return mesh;
}

Shape shapeOf(Mesh mesh, double unit = 1.0) {
  ShapeBody body;
  body.kind = BodyKind::mesh;
  body.mesh = std::make_shared<const Mesh>(std::move(mesh));
  body.unit = unit;
  Shape shape;
  shape.bodies.push_back(body);
  return shape;
}

struct Sampled {
  BodySamples samples;
  Findings findings;
  std::string error;
  bool has(const std::string& code) const {
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; });
  }
};

Sampled sample(const Shape& shape) {
  Sampled result;
  auto samples = sampleShape(shape, result.findings);
  if (samples)
    result.samples = samples->front();
  else
    result.error = samples.error().message;
  return result;
}

Matrix4d boxMoments(const Vector3d& center, const Vector3d& size) {
  ShapeBody box;
  box.dims = {size.x(), size.y(), size.z()};
  Matrix4d X = Matrix4d::Identity();
  X.topRightCorner<3, 1>() = center;
  return X * primitiveMoments(box) * X.transpose();
}

constexpr double kFloat = 2e-6;  // relative; mesh vertices are floats

void expectMoments(const BodySamples& samples, const Matrix4d& moments, double tolerance) {
  EXPECT_NEAR(samples.volume, moments(3, 3), tolerance * moments(3, 3));
  EXPECT_LT((samples.unitPseudoInertia - moments / moments(3, 3)).norm(), tolerance * (moments / moments(3, 3)).norm())
      << samples.unitPseudoInertia << "\nexpected\n"
      << moments / moments(3, 3);
}

const Vector3d kCenter(0.3, -0.2, 0.5), kSize(0.1, 0.2, 0.06);

TEST(MeshVolume, BoxMeshHasTheMomentsOfABox) {
  const Sampled got = sample(shapeOf(boxMesh(kCenter, kSize, 5)));
  ASSERT_EQ(got.error, "");
  EXPECT_TRUE(got.findings.empty());
  expectMoments(got.samples, boxMoments(kCenter, kSize), kFloat);
  const Matrix4d points = pseudoInertiaOf({got.samples.points, got.samples.weights});
  EXPECT_LT((points - got.samples.unitPseudoInertia).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_GE(got.samples.points.cols(), 500);
  EXPECT_LE(got.samples.points.cols(), 1500);
}

TEST(MeshVolume, UnitScales) {
  const Sampled got = sample(shapeOf(boxMesh(1000 * kCenter, 1000 * kSize), 0.001));
  ASSERT_EQ(got.error, "");
  EXPECT_TRUE(got.findings.empty());
  expectMoments(got.samples, boxMoments(kCenter, kSize), kFloat);
}

TEST(MeshVolume, SphereOfTrianglesApproachesTheSphere) {
  std::vector<Eigen::Vector2d> profile;
  const int n = 120;
  for (int i = 0; i <= n; ++i) {
    const double angle = std::numbers::pi * i / n;
    profile.emplace_back(i == 0 || i == n ? 0.0 : 0.1 * std::sin(angle), -0.1 * std::cos(angle));
  }
  const Sampled got = sample(shapeOf(turned(profile, 240)));
  ASSERT_EQ(got.error, "");
  EXPECT_TRUE(got.findings.empty());
  EXPECT_NEAR(got.samples.volume, 4.0 / 3.0 * std::numbers::pi * 1e-3, 1e-3 * 4e-3);
  EXPECT_NEAR(got.samples.unitPseudoInertia(0, 0), 0.002, 2e-6);
  const double farthest = got.samples.points.colwise().norm().maxCoeff();
  EXPECT_LT(farthest, 0.101);
  EXPECT_GT(farthest, 0.095);
}

TEST(MeshVolume, PointsBeforeTheCorrectionAreWithinOnePercent) {
  const ClosedPieces closed =
      closePieces(weld(turned({{0, 0}, {0.05, 0}, {0.05, 0.01}, {0.01, 0.02}, {0.01, 0.3}, {0, 0.3}}, 64), 1.0));
  ASSERT_EQ(closed.pieces.size(), 1u);
  const Surface& surface = closed.pieces[0];
  const Matrix4d moments = volumeMoments(surface);
  const WeightedPoints fine = volumePoints(surface, moments);
  EXPECT_NEAR(fine.weights.sum(), moments(3, 3), 0.01 * moments(3, 3));
  const Matrix4d got = pseudoInertiaOf(thinned(fine, 1024)), exact = moments / moments(3, 3);
  const Vector3d c = exact.topRightCorner<3, 1>();
  const Matrix3d cov = exact.topLeftCorner<3, 3>() - c * c.transpose();
  const Vector3d gotC = got.topRightCorner<3, 1>();
  const Matrix3d gotCov = got.topLeftCorner<3, 3>() - gotC * gotC.transpose();
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(gotCov(i, i), cov(i, i), 0.01 * cov(i, i));
    EXPECT_NEAR(gotC[i], c[i], 0.01 * std::sqrt(cov(i, i)));
  }
}

TEST(MeshVolume, CavityIsSubtractedWhicheverWayTheWholeFileIsTurned) {
  for (const bool insideOut : {false, true}) {
    Mesh mesh;
    addBox(mesh, kCenter, kSize, 2, insideOut);
    addBox(mesh, kCenter + Vector3d(0.01, 0, 0), 0.6 * kSize, 2, !insideOut);
    const Sampled got = sample(shapeOf(mesh));
    ASSERT_EQ(got.error, "");
    EXPECT_EQ(got.has("mesh_inside_out"), insideOut);
    expectMoments(got.samples, boxMoments(kCenter, kSize) - boxMoments(kCenter + Vector3d(0.01, 0, 0), 0.6 * kSize),
                  1e-5);
    for (Eigen::Index i = 0; i < got.samples.points.cols(); ++i) {
      const Vector3d p = got.samples.points.col(i) - kCenter - Vector3d(0.01, 0, 0);
      EXPECT_FALSE((p.cwiseAbs().array() < 0.29 * kSize.array()).all()) << "a point in the cavity: " << p.transpose();
    }
  }
}

TEST(MeshVolume, OneInsideOutPieceBesideAnotherIsTurned) {
  Mesh mesh;
  addBox(mesh, {0, 0, 0}, {0.2, 0.1, 0.1});
  addBox(mesh, {0.2, 0, 0}, {0.1, 0.1, 0.1}, 1, true);
  const Sampled got = sample(shapeOf(mesh));
  ASSERT_EQ(got.error, "");
  EXPECT_TRUE(got.has("mesh_inside_out"));
  EXPECT_NEAR(got.samples.volume, 0.003, 1e-8);
}

TEST(MeshVolume, TurnedTrianglesAreTurnedBack) {
  Mesh mesh = boxMesh(kCenter, kSize, 4);
  for (const std::size_t i : {3u, 17u, 40u, 41u, 90u})
    std::swap(mesh.parts[0].triangles[i][0], mesh.parts[0].triangles[i][1]);
  const Sampled got = sample(shapeOf(mesh));
  ASSERT_EQ(got.error, "");
  ASSERT_TRUE(got.has("mesh_orientation"));
  EXPECT_THAT(got.findings[0].text, HasSubstr("5 triangles"));
  expectMoments(got.samples, boxMoments(kCenter, kSize), kFloat);
}

TEST(MeshVolume, SmallHolesAreCoveredAndReported) {
  Mesh mesh = boxMesh(kCenter, kSize, 8);
  auto& triangles = mesh.parts[0].triangles;
  triangles.erase(triangles.begin() + 100);
  triangles.erase(triangles.begin() + 300, triangles.begin() + 302);
  const Sampled got = sample(shapeOf(mesh));
  ASSERT_EQ(got.error, "");
  ASSERT_TRUE(got.has("mesh_open"));
  EXPECT_THAT(got.findings[0].text, HasSubstr("7 open edges"));
  expectMoments(got.samples, boxMoments(kCenter, kSize), kFloat);  // flat holes: the cover is the missing triangle
}

TEST(MeshVolume, SeamsOfRoundedVerticesAreClosed) {
  Mesh mesh = boxMesh(kCenter, kSize, 3);
  for (std::size_t i = 0; i < mesh.parts[0].vertices.size(); i += 2) mesh.parts[0].vertices[i].x() += 5e-8f;
  const Sampled got = sample(shapeOf(mesh));
  ASSERT_EQ(got.error, "");
  EXPECT_TRUE(got.findings.empty());
  expectMoments(got.samples, boxMoments(kCenter, kSize), 1e-5);
}

TEST(MeshVolume, AnOpenSheetHasNoVolumeButMayBeAShell) {
  Mesh sheet;
  addTriangle(sheet, {0, 0, 0}, {0.2, 0, 0}, {0.2, 0.1, 0});
  addTriangle(sheet, {0, 0, 0}, {0.2, 0.1, 0}, {0, 0.1, 0});
  Shape shape = shapeOf(sheet);
  EXPECT_THAT(sample(shape).error,
              AllOf(HasSubstr("encloses no volume"), HasSubstr("4 open edges"), HasSubstr("wall")));
  shape.bodies[0].wall = 0.002;
  const Sampled got = sample(shape);
  ASSERT_EQ(got.error, "");
  expectMoments(got.samples, boxMoments({0.1, 0.05, 0}, {0.2, 0.1, 0.002}), kFloat);
}

TEST(MeshVolume, ClosedShellIsTheDifferenceOfTwoSpheresToFirstOrder) {
  Shape shape = shapeOf(boxMesh(kCenter, kSize, 3));
  shape.bodies[0].wall = 1e-5;
  const Sampled got = sample(shape);
  ASSERT_EQ(got.error, "");
  const Vector3d t = Vector3d::Constant(1e-5);
  expectMoments(got.samples, boxMoments(kCenter, kSize + t) - boxMoments(kCenter, kSize - t), 1e-3);
}

TEST(MeshVolume, MillimetresReadAsMetres) {
  Sampled got = sample(shapeOf(boxMesh({0, 0, 0}, {200, 30, 20})));
  EXPECT_THAT(got.error, AllOf(HasSubstr("200 m long"), HasSubstr("in millimetres set unit to mm")));
  got = sample(shapeOf(boxMesh({0, 0, 0}, {3.2, 0.3, 0.2})));
  ASSERT_EQ(got.error, "");
  ASSERT_TRUE(got.has("shape_size"));
  EXPECT_THAT(got.findings[0].text, HasSubstr("3.2 m long"));
  got = sample(shapeOf(boxMesh({0, 0, 0}, {0.2, 0.03, 0.02}), 0.001));
  ASSERT_EQ(got.error, "");
  ASSERT_TRUE(got.has("shape_size"));
  EXPECT_THAT(got.findings[0].remedy, HasSubstr("set unit to m."));
}

TEST(MeshVolume, BrokenMeshesGiveASentence) {
  EXPECT_THAT(sample(shapeOf(Mesh{})).error, HasSubstr("no triangles"));
  Mesh line;
  addTriangle(line, {0, 0, 0}, {0.1, 0, 0}, {0.1, 0, 0});
  EXPECT_THAT(sample(shapeOf(line)).error, HasSubstr("no triangles"));
  Mesh collinear;
  addTriangle(collinear, {0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0});
  EXPECT_NE(sample(shapeOf(collinear)).error, "");
  Mesh bad = boxMesh(kCenter, kSize, 4);
  bad.parts[0].vertices[5].x() = std::numeric_limits<float>::quiet_NaN();
  bad.parts[0].triangles[9][1] = 1u << 30;
  const Sampled got = sample(shapeOf(bad));
  ASSERT_EQ(got.error, "");
  EXPECT_TRUE(got.has("mesh_bad_triangles"));
  EXPECT_TRUE(got.has("mesh_open"));
  expectMoments(got.samples, boxMoments(kCenter, kSize), 0.05);
}

TEST(MeshVolume, BodiesThatTouchAlongAnEdgeAreBothCounted) {
  Mesh mesh;
  addBox(mesh, {0, 0, 0}, {0.1, 0.1, 0.1});
  addBox(mesh, {0.1, 0.1, 0}, {0.1, 0.1, 0.1});
  const Sampled got = sample(shapeOf(mesh));
  ASSERT_EQ(got.error, "");
  EXPECT_TRUE(got.has("mesh_non_manifold"));
  EXPECT_NEAR(got.samples.volume, 0.002, 1e-8);
}

TEST(MeshVolume, PointsKnowTheirPieceAndEachPieceHasItsOwnMoments) {
  Mesh mesh;
  addBox(mesh, {0, 0, 0}, {0.04, 0.04, 0.2});
  addBox(mesh, {0, 0, 0.12}, {0.1, 0.03, 0.04});  // touches the first one's end without sharing vertices
  const Sampled got = sample(shapeOf(mesh));
  ASSERT_EQ(got.error, "");
  ASSERT_EQ(got.samples.piece.size(), got.samples.points.cols());
  ASSERT_EQ(got.samples.piece.maxCoeff(), 1);
  for (int piece = 0; piece < 2; ++piece) {
    Matrix4d P = Matrix4d::Zero();
    for (Eigen::Index i = 0; i < got.samples.points.cols(); ++i) {
      if (got.samples.piece[i] != piece) continue;
      const Eigen::Vector4d x = got.samples.points.col(i).homogeneous();
      EXPECT_EQ(x.z() > 0.1, piece == 1) << "pieces are ordered by volume";
      P += got.samples.weights[i] * x * x.transpose();
    }
    const Matrix4d exact =
        piece == 0 ? boxMoments({0, 0, 0}, {0.04, 0.04, 0.2}) : boxMoments({0, 0, 0.12}, {0.1, 0.03, 0.04});
    EXPECT_LT((got.samples.volume * P - exact).cwiseAbs().maxCoeff(), 1e-5 * exact(3, 3));
  }
}

TEST(MeshVolume, LoosePatchesAreClosedTogether) {
  Mesh whole = boxMesh(kCenter, kSize, 1), mesh;  // the six faces of a box, each a little smaller than it should be
  for (const auto& t : whole.parts[0].triangles) {
    std::array<Vector3d, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = whole.parts[0].vertices[t[k]].cast<double>();
    const Vector3d middle = (v[0] + v[1] + v[2]) / 3.0;
    for (Vector3d& p : v) p += 1e-3 * (middle - p);
    addTriangle(mesh, v[0], v[1], v[2]);
  }
  const Sampled got = sample(shapeOf(mesh));
  ASSERT_NE(got.error, "") << "nothing connects these triangles";
  EXPECT_THAT(got.error, HasSubstr("encloses no volume"));
}

TEST(MeshVolume, OverlapIsCountedTwiceAndSaid) {
  Mesh mesh;
  addBox(mesh, {0, 0, 0}, {0.2, 0.1, 0.1});
  addBox(mesh, {0.1, 0, 0}, {0.2, 0.08, 0.08});
  const Sampled got = sample(shapeOf(mesh));
  ASSERT_EQ(got.error, "");
  EXPECT_TRUE(got.has("mesh_overlap"));
  expectMoments(got.samples, boxMoments({0, 0, 0}, {0.2, 0.1, 0.1}) + boxMoments({0.1, 0, 0}, {0.2, 0.08, 0.08}),
                kFloat);
}

std::filesystem::path sharedTools() {
  if (const char* shared = std::getenv("HEFT_SHARED")) return std::filesystem::path(shared) / "tools";
  return std::filesystem::path(HEFT_SOURCE_DIR) / ".." / "shared" / "tools";
}

class Tools : public ::testing::TestWithParam<const char*> {};

TEST_P(Tools, RealToolsLieInsideTheirBox) {
  const auto file = sharedTools() / (std::string(GetParam()) + ".ply");
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file << " is not there: the real tools come with the shared material.";
  ShapeBody body;
  body.kind = BodyKind::mesh;
  body.file = file;
  body.unit = 0.001;
  auto mesh = loadMesh(file);
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  body.mesh = std::make_shared<const Mesh>(std::move(*mesh));
  Shape shape;
  shape.bodies.push_back(body);
  const Sampled got = sample(shape);
  ASSERT_EQ(got.error, "");
  for (const Finding& f : got.findings) std::cout << toLine(f) << "\n";
  std::cout << GetParam() << ": " << body.mesh->triangleCount() << " triangles, " << got.samples.points.cols()
            << " points, volume " << 1e6 * got.samples.volume << " cm3\n";

  std::ifstream in(sharedTools() / (std::string(GetParam()) + ".json"));
  const auto truth = nlohmann::json::parse(in);
  // The true mass lies between that of a tool all of rubber or plastic and all of steel; the centre inside the tool's
  // extent.
  const double density = truth["mass_kg"].get<double>() / got.samples.volume;
  EXPECT_GT(density, 900.0);
  EXPECT_LT(density, 8000.0);
  const Vector3d low = got.samples.points.rowwise().minCoeff(), high = got.samples.points.rowwise().maxCoeff();
  const auto com = truth["com_in_mesh_m"].get<std::vector<double>>();
  const Vector3d centroid = got.samples.unitPseudoInertia.topRightCorner<3, 1>();
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(com[k], centroid[i], 0.4 * (high[i] - low[i]));
  }
  if (std::string(GetParam()) == "box_wrench" || std::string(GetParam()) == "pliers") {
    // One material: the homogeneous body is the truth.
    EXPECT_LT((Vector3d(com[0], com[1], com[2]) - centroid).norm(), 1e-3) << centroid.transpose();
    const Payload unit = fromParameters(parametersFromPseudoInertia(got.samples.unitPseudoInertia));
    for (int i = 0; i < 3; ++i) {
      const double expected =
          truth["inertia_com_kgm2"][static_cast<std::size_t>(i)][static_cast<std::size_t>(i)].get<double>() /
          truth["mass_kg"].get<double>();
      EXPECT_NEAR(unit.inertiaCom(i, i), expected, 0.01 * expected);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Tools,
                         ::testing::Values("box_wrench", "clamp", "hammer", "measuring_tape", "pliers", "screwdriver"));

}  // namespace
}  // namespace heft
