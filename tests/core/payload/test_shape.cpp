// Closed forms of the primitives, their points, and what is said about bad input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "core/payload/shape.h"
#include "core/payload/shape_moments.h"

namespace heft {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Shape shapeOf(const std::string& text) {
  auto shape = parseShape(text);
  EXPECT_TRUE(shape.ok()) << (shape.ok() ? "" : shape.error().message);
  return *shape;
}

BodySamples samplesOf(const Shape& shape) {
  Findings findings;
  auto samples = sampleShape(shape, findings);
  EXPECT_TRUE(samples.ok()) << (samples.ok() ? "" : samples.error().message);
  EXPECT_TRUE(findings.empty());
  return samples->front();
}

/// Moments by throwing points into a bounding box [m], without any of the code that is tested but insidePrimitive.
Matrix4d monteCarlo(const ShapeBody& body, const Vector3d& low, const Vector3d& high, int count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Matrix4d M = Matrix4d::Zero();
  for (int i = 0; i < count; ++i) {
    Eigen::Vector4d p{uniform(random), uniform(random), uniform(random), 1.0};
    p.head<3>() = low + (high - low).cwiseProduct(p.head<3>());
    if (insidePrimitive(body, p.head<3>())) M += p * p.transpose();
  }
  return M * (high - low).prod() / count;
}

double relativeDifference(const Matrix4d& a, const Matrix4d& b) {
  // Compared per unit mass in units of the body's own spread, so that metres and kilograms do not hide anything.
  const Vector3d c = b.topRightCorner<3, 1>() / b(3, 3);
  const Vector3d spread = (b.diagonal().head<3>() / b(3, 3) - c.cwiseProduct(c)).cwiseSqrt();
  Eigen::Vector4d scale;
  scale << spread.cwiseInverse(), 1.0;
  Matrix4d shift = Matrix4d::Identity();
  shift.topRightCorner<3, 1>() = -c;
  return (scale.asDiagonal() * shift * (a - b) * shift.transpose() * scale.asDiagonal()).cwiseAbs().maxCoeff() /
         b(3, 3);
}

class Primitives : public ::testing::TestWithParam<const char*> {};

TEST_P(Primitives, ClosedFormAgreesWithMonteCarlo) {
  const Shape shape = shapeOf(GetParam());
  const ShapeBody& body = shape.bodies[0];
  double size = 0.0;
  for (const double d : body.dims) size = std::max(size, d);
  double reach = size;
  if (body.kind == BodyKind::capsule) reach = body.dims[0] + body.dims[1];
  const Vector3d corner = Vector3d::Constant(reach);
  const Matrix4d truth = monteCarlo(body, -corner, corner, 1'000'000);
  // Moments of bounded bodies scatter by about one over the root of the hits; five sigma.
  const double hits = 1e6 * truth(3, 3) / std::pow(2 * reach, 3);
  EXPECT_LT(relativeDifference(primitiveMoments(body), truth), 5.0 / std::sqrt(hits)) << truth;
}

TEST_P(Primitives, PointsCarryTheExactMomentsAndLieInside) {
  Shape shape = shapeOf(GetParam());
  ShapeBody& body = shape.bodies[0];
  body.X_SB = poseFromXyzRpy({0.1, -0.2, 0.3}, {0.4, -0.5, 1.1});
  const BodySamples samples = samplesOf(shape);
  EXPECT_GE(samples.points.cols(), 500);
  EXPECT_LE(samples.points.cols(), 1500);
  EXPECT_GT(samples.weights.minCoeff(), 0.0);
  EXPECT_NEAR(samples.weights.sum(), 1.0, 1e-12);
  EXPECT_NEAR(samples.unitPseudoInertia(3, 3), 1.0, 1e-14);
  const Matrix4d fromPoints = pseudoInertiaOf({samples.points, samples.weights});
  EXPECT_LT((fromPoints - samples.unitPseudoInertia).cwiseAbs().maxCoeff(), 1e-13);
  const Matrix4d exact = body.X_SB.matrix() * primitiveMoments(body) * body.X_SB.matrix().transpose();
  EXPECT_LT((samples.volume * fromPoints - exact).cwiseAbs().maxCoeff(), 1e-12 * samples.volume);
  const Eigen::Matrix3Xd inBody = body.X_SB.inverse() * samples.points;
  long outside = 0;  // the final correction moves points near a face by a fraction of a percent
  for (Eigen::Index i = 0; i < inBody.cols(); ++i) outside += !insidePrimitive(body, inBody.col(i));
  EXPECT_LT(outside, inBody.cols() / 20);
}

TEST_P(Primitives, ThinnedPointsAreWithinOnePercentBeforeTheCorrection) {
  const ShapeBody body = shapeOf(GetParam()).bodies[0];
  const WeightedPoints few = thinned(primitivePoints(body), 1024);
  const Matrix4d exact = primitiveMoments(body);
  EXPECT_LT(relativeDifference(pseudoInertiaOf(few), exact / exact(3, 3)), 0.01);
}

TEST_P(Primitives, TheSameInputGivesTheSamePoints) {
  const Shape shape = shapeOf(GetParam());
  EXPECT_EQ(samplesOf(shape).points, samplesOf(shape).points);
}

INSTANTIATE_TEST_SUITE_P(All, Primitives,
                         ::testing::Values("box:0.1,0.2,0.3", "box:0.1,0.2,0.05:wall=0.004", "cylinder:0.05,0.2",
                                           "cylinder:0.05,0.2:wall=0.003", "tube:0.05,0.04,0.2", "tube:0.05,0,0.2",
                                           "sphere:0.07", "sphere:0.07:wall=0.002", "cone:0.06,0.15",
                                           "cone:0.06,0.15:wall=0.005", "capsule:0.03,0.1", "capsule:0.03,0",
                                           "capsule:0.03,0.1:wall=0.002", "plate:0.2,0.1,0.01",
                                           "plate:0.2,0.1,0.02:wall=0.001"));

TEST(Shape, TextbookValues) {
  // Sphere 2/5 m r^2, solid cylinder m r^2/2 and m (3 r^2 + h^2)/12, cone 3/10 m r^2, as tensors about the centre of
  // mass.
  const auto inertia = [](const std::string& text) {
    return fromParameters(parametersFromPseudoInertia(samplesOf(shapeOf(text)).unitPseudoInertia)).inertiaCom;
  };
  EXPECT_NEAR(inertia("sphere:0.1")(0, 0), 0.4 * 0.01, 1e-15);
  EXPECT_NEAR(inertia("cylinder:0.1,0.3")(2, 2), 0.5 * 0.01, 1e-15);
  EXPECT_NEAR(inertia("cylinder:0.1,0.3")(0, 0), (3 * 0.01 + 0.09) / 12, 1e-15);
  EXPECT_NEAR(inertia("cone:0.1,0.3")(2, 2), 0.3 * 0.01, 1e-15);
  EXPECT_NEAR(inertia("box:0.1,0.2,0.3")(0, 0), (0.04 + 0.09) / 12, 1e-15);
  const BodySamples cone = samplesOf(shapeOf("cone:0.1,0.4@0,0,1"));
  EXPECT_NEAR(cone.unitPseudoInertia(2, 3), 1.1, 1e-14) << "a quarter of the height above the base centre";
  EXPECT_NEAR(samplesOf(shapeOf("sphere:0.1:wall=0.02")).volume, 4.0 / 3.0 * std::numbers::pi * (1e-3 - 0.512e-3),
              1e-15);
}

TEST(Shape, PoseIsFixedAxisRollPitchYaw) {
  const Shape shape = shapeOf("cone:0.05,0.4@0.1,0.2,0.3,1.5707963267948966,0,1.5707963267948966");
  // Roll turns z to -y, yaw then turns -y to +x: the apex points along +x.
  const BodySamples samples = samplesOf(shape);
  EXPECT_TRUE(Vector3d(0.2, 0.2, 0.3).isApprox(samples.unitPseudoInertia.topRightCorner<3, 1>(), 1e-12))
      << samples.unitPseudoInertia;
}

TEST(Shape, MassFromDensity) {
  Shape shape = shapeOf("box:0.1,0.1,0.1");
  shape.bodies[0].density = 7850.0;
  EXPECT_NEAR(*samplesOf(shape).mass, 7.85, 1e-12);
  shape.bodies[0].density = 7.85;
  Findings findings;
  ASSERT_TRUE(sampleShape(shape, findings).ok());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_THAT(findings[0].remedy, HasSubstr("g/cm3"));
}

struct Bad {
  const char* text;
  const char* says;
};
class BadText : public ::testing::TestWithParam<Bad> {};
TEST_P(BadText, IsOneSentenceThatNamesWhatIsExpected) {
  const auto shape = parseShape(GetParam().text);
  ASSERT_FALSE(shape.ok());
  EXPECT_THAT(shape.error().message,
              AllOf(HasSubstr(GetParam().says), HasSubstr("cylinder:radius,height"), HasSubstr(GetParam().text)));
}
INSTANTIATE_TEST_SUITE_P(
    All, BadText,
    ::testing::Values(
        Bad{"ball:1", "'ball' is not one of the kinds"}, Bad{"box", "dimensions of the box are missing"},
        Bad{"", "'' is not one of the kinds"}, Bad{"box:0.1,0.2", "needs 3 dimensions"},
        Bad{"sphere:0.1,0.2", "needs 1 dimension in metres (radius), but 2 are given"},
        Bad{"box:0.1,-0.2,0.3", "y (box:x,y,z) must be a positive number of metres, not -0.2"},
        Bad{"cylinder:0,0.1", "radius"}, Bad{"sphere:nan", "'nan' is not a number"},
        Bad{"sphere:inf", "'inf' is not a number"}, Bad{"sphere:0,1", "needs 1 dimension"},
        Bad{"tube:0.03,0.03,0.1", "must be larger than the inner one"},
        Bad{"tube:0.02,0.03,0.1", "must be larger than the inner one"}, Bad{"box:0.1,,0.2", "'' is not a number"},
        Bad{"box:0.1,0.1,0.1@1,2", "a pose has 3 or 6 numbers, not 2"},
        Bad{"box:0.1,0.1,0.1@1,2,x", "'x' is not a number"}, Bad{"box:0.1,0.1,0.1:wall=0.05", "leaves no hollow"},
        Bad{"box:0.1,0.1,0.1:wall=-1", "the wall must be"}, Bad{"box:0.1,0.1,0.1:walls=1", "is not wall=THICKNESS"},
        Bad{"tube:0.03,0.02,0.1:wall=0.001", "a tube is hollow already"}, Bad{"mesh:tool.ply", "--shape-file"}));

TEST(Shape, MessagesStayOnePrintableLine) {
  const auto shape = parseShape("box:\xff\x1b[2J\n" + std::string(100000, '1'));
  ASSERT_FALSE(shape.ok());
  EXPECT_LT(shape.error().message.size(), 1500u);
  EXPECT_EQ(shape.error().message.find_first_of("\x1b\n\xff"), std::string::npos);
}

TEST(Shape, DimensionsInMillimetresAreCaught) {
  Findings findings;
  const auto samples = sampleShape(shapeOf("box:100,50,20"), findings);
  ASSERT_FALSE(samples.ok());
  EXPECT_THAT(samples.error().message, AllOf(HasSubstr("100 m long"), HasSubstr("Dimensions are in metres")));
}

class ShapeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) / "heft_shape_file";
    std::filesystem::create_directories(folder_);
  }
  std::filesystem::path write(const std::string& text) {
    const auto path = folder_ / "tool.json";
    std::ofstream(path) << text;
    return path;
  }
  std::string errorOf(const std::string& text) {
    const auto shape = readShapeFile(write(text));
    return shape.ok() ? "" : shape.error().message;
  }
  std::filesystem::path folder_;
};

TEST_F(ShapeFile, ReadsTheContract) {
  const auto shape = readShapeFile(write(R"({"bodies": [
      {"kind": "box", "dims_m": [0.1, 0.2, 0.3], "xyz_m": [1, 2, 3], "rpy_rad": [0, 0, 0], "mass_kg": null,
       "density_kg_m3": 2700},
      {"kind": "cylinder", "dims_m": [0.01, 0.2], "wall_m": 0.002, "mass_kg": 0.3},
      {"kind": "mesh", "file": "tool.ply", "unit": "mm", "xyz_m": [0, 0, 0.1], "rpy_rad": [0, 1.5, 0]}],
      "certainty": "good", "total_mass_kg": 20.5})"));
  ASSERT_TRUE(shape.ok()) << shape.error().message;
  ASSERT_EQ(shape->bodies.size(), 3u);
  EXPECT_EQ(shape->certainty, Certainty::good);
  EXPECT_EQ(shape->totalMass, 20.5);
  EXPECT_EQ(shape->bodies[0].density, 2700.0);
  EXPECT_FALSE(shape->bodies[0].mass);
  EXPECT_EQ(shape->bodies[0].X_SB.translation(), Vector3d(1, 2, 3));
  EXPECT_EQ(shape->bodies[1].wall, 0.002);
  EXPECT_EQ(shape->bodies[2].file, folder_ / "tool.ply");
  EXPECT_EQ(shape->bodies[2].unit, 0.001);

  const auto again = shapeFromJson(toJson(*shape), "again", folder_);
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(toJson(*again), toJson(*shape));
}

TEST_F(ShapeFile, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(errorOf("{\"bodies\": [}"), HasSubstr("tool.json:1:13"));
  EXPECT_THAT(errorOf("[]"), HasSubstr("object with the key \"bodies\""));
  EXPECT_THAT(errorOf(R"({"bodies": []})"), HasSubstr("at least one body"));
  EXPECT_THAT(errorOf(R"({"bodies": [3]})"), HasSubstr("bodies[0] must be an object"));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "ball"}]})"), AllOf(HasSubstr("bodies[0].kind"), HasSubstr("capsule")));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "box"}]})"), AllOf(HasSubstr("bodies[0].dims_m"), HasSubstr("x, y, z")));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "box", "dims_m": [1, 2]}]})"), HasSubstr("needs 3 dimensions"));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "box", "dims_m": [1, 2, 0]}]})"), HasSubstr("z (box:x,y,z)"));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "mesh"}]})"), HasSubstr("bodies[0].file"));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "mesh", "file": "a.ply", "unit": "feet"}]})"), HasSubstr("\"mm\""));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "sphere", "dims_m": [1], "xyz_m": [1, 2]}]})"), HasSubstr("xyz_m"));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "sphere", "dims_m": [1], "mass_kg": -1}]})"), HasSubstr("mass must be"));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "sphere", "dims_m": [1], "mass_kg": "1"}]})"), HasSubstr("mass_kg"));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "sphere", "dims_m": [1], "mass_kg": 1, "density_kg_m3": 1}]})"),
              HasSubstr("not both"));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "sphere", "dims_m": [1]}], "certainty": "sure"})"),
              HasSubstr("\"rough\""));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "sphere", "dims_m": [1], "mass_kg": 2}], "total_mass_kg": 1})"),
              HasSubstr("total"));
  EXPECT_THAT(errorOf(R"({"bodies": [{"kind": "sphere", "dims_m": [1]}], "total_mass_kg": 0})"),
              HasSubstr("total mass"));
}

}  // namespace
}  // namespace heft
