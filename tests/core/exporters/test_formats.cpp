// Every format read back gives the payload; each by a reader of its own.
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <nlohmann/json.hpp>

#include "tests/core/exporters/readers.h"

namespace heft {
namespace {

std::string exported(std::string_view id, const ExportInput& input) {
  Findings findings;
  const ExportFormat* format = findExportFormat(id);
  if (!format) throw std::runtime_error("no such format");
  return exportPayload(*format, input, findings).value();
}

class EveryFormat : public testing::TestWithParam<std::string> {};

TEST_P(EveryFormat, ReadsBackForTwoHundredBodies) {
  const std::string id = GetParam();
  for (int index = 0; index < 200; ++index) {
    SCOPED_TRACE(testing::Message() << id << ", body " << index);
    ExportInput input;
    input.payload = randomPayload(index);
    input.provenance = "made by -- a test; with ] odd } signs > and & \" ' 1 2 3";
    input.uncertainty = "mass 1 to 2 kg";
    ASSERT_TRUE(checkPhysical(input.payload).physical);
    const std::string text = exported(id, input);
    const Payload back = readBack(id, text);
    const Matrix3d& I = input.payload.inertiaCom;
    const double largest = I.cwiseAbs().maxCoeff();
    EXPECT_NEAR(back.mass, input.payload.mass, 6e-6) << text;
    EXPECT_LT((back.com - input.payload.com).cwiseAbs().maxCoeff(), 6e-7) << text;
    if (!holdsInertia(id)) continue;
    if (id == "fanuc") {
      EXPECT_LT((back.inertiaCom.diagonal() - I.diagonal()).cwiseAbs().maxCoeff(), 1e-5 * largest) << text;
    } else {
      EXPECT_LT((back.inertiaCom - I).cwiseAbs().maxCoeff(), 6e-6 * largest) << text;
      EXPECT_TRUE(checkPhysical({back.mass, back.com, 0.5 * (back.inertiaCom + back.inertiaCom.transpose())}).physical)
          << checkPhysical(back).reason << "\n"
          << text;
    }
  }
}

TEST_P(EveryFormat, PrincipalAxesRebuildTheTensorThatOthersWrite) {
  const std::string id = GetParam();
  if (id == "fanuc") GTEST_SKIP() << "It has no products of inertia.";
  if (!holdsInertia(id)) GTEST_SKIP() << "It has no inertia.";
  for (int index = 0; index < 200; ++index) {
    ExportInput input;
    input.payload = randomPayload(index);
    const Payload rounded = roundedForExport(input.payload);
    const Payload back = readBack(id, exported(id, input));
    EXPECT_EQ(back.mass, rounded.mass);
    EXPECT_LT((back.com - rounded.com).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LT((back.inertiaCom - rounded.inertiaCom).cwiseAbs().maxCoeff(),
              2e-8 * rounded.inertiaCom.cwiseAbs().maxCoeff())
        << id << ", body " << index;
  }
}

std::vector<std::string> allIds() {
  std::vector<std::string> ids;
  for (const ExportFormat& format : exportFormats()) ids.emplace_back(format.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, testing::ValuesIn(allIds()), [](const auto& test) {
  std::string name = test.param;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
});

TEST(ExportFormats, DeskFileHoldsNothingBeyondItsFourKeys) {
  const nlohmann::json json = nlohmann::json::parse(exported("franka-desk", goldenInput()));
  EXPECT_EQ(json.size(), 4u);
  // Column-based: the translation sits at 12 to 14, the first column at 0 to 2.
  const auto X = json.at("transformation").get<std::vector<double>>();
  ASSERT_EQ(X.size(), 16u);
  EXPECT_NEAR(X[0], std::sqrt(0.5), 1e-11);
  EXPECT_NEAR(X[1], -std::sqrt(0.5), 1e-11);
  EXPECT_NEAR(X[4], std::sqrt(0.5), 1e-11);
  EXPECT_EQ(X[13], 0.01);
  EXPECT_EQ(X[14], 0.1034);
  EXPECT_EQ(X[15], 1.0);
  EXPECT_EQ(X[3], 0.0);
}

/// The estimate of a sensor that is turned and moved on the flange, with its bias.
ExportInput sensorInput() {
  ExportInput input;
  const Isometry3d X_FS = poseFromXyzRpy({0.01, 0.0, 0.04}, {0.0, 0.0, 1.5707963267948966});
  const Payload own{0.8, {0.02, -0.01, 0.05}, Vector3d(0.002, 0.0025, 0.0015).asDiagonal()};
  input.sensor = SensorSide{own, X_FS, Vector6d(), "wrist_ft"};
  *input.sensor->bias << 1.5, -2.0, 0.25, 0.01, 0.02, -0.03;
  input.payload = transformed(own, X_FS);
  return input;
}

TEST(ExportFormats, WhatTakesTheWeightOffIsInTheSensorsFrame) {
  const std::string filter = exported("ros2-control", sensorInput());
  EXPECT_NE(filter.find("sensor_frame: wrist_ft\ntool:\n  mass: 0.8\n  pos: [0.02, -0.01, 0.05]\n"), std::string::npos)
      << filter;
  const std::string tools = exported("force-torque-tools", sensorInput());
  EXPECT_NE(tools.find("bias: [1.5, -2.0, 0.25, 0.01, 0.02, -0.03]\ngripper_com_frame_id: wrist_ft\n"
                       "gripper_com_pose: [0.02, -0.01, 0.05, 0.0, 0.0, 0.0]\ngripper_mass: 0.8\n"),
            std::string::npos)
      << tools;
}

TEST(ExportFormats, McRtcHasTheCoupleFirstTheOtherSignAndTheFlangesFrame) {
  // The mass, no turn, the centre from the flange, -torque, -force.
  EXPECT_EQ(exported("mc-rtc", sensorInput()).substr(0, 64).find("0.8\n0 0 0\n0.02 0.02 0.09\n-0.01 -0.02 0.03\n"), 0u)
      << exported("mc-rtc", sensorInput());
  EXPECT_NE(exported("mc-rtc", sensorInput()).find("\n-1.5 2 -0.25\n"), std::string::npos);
}

TEST(ExportFormats, AFrameNameCannotBreakAFile) {
  ExportInput input = sensorInput();
  input.sensor->frame = "a b: [\n#";
  EXPECT_NE(exported("ros2-control", input).find("sensor_frame: a_b_____\n"), std::string::npos);
}

TEST(ExportFormats, SdfTurnsNothingInItsPose) {
  EXPECT_NE(exported("sdf", goldenInput()).find("<pose>0.012346 -0.0045 0.067891 0 0 0</pose>"), std::string::npos);
}

TEST(ExportFormats, AUrdfHasAMasslessParentOnRequest) {
  ExportInput input = goldenInput();
  input.name = "tool";
  input.parentLink = "flange";
  const auto model = urdf::parseURDF(exported("urdf", input));
  ASSERT_TRUE(model);
  EXPECT_EQ(model->getRoot()->name, "flange");
  EXPECT_FALSE(model->getRoot()->inertial);
  ASSERT_TRUE(model->getLink("tool") && model->getLink("tool")->inertial);
  EXPECT_EQ(model->getLink("tool")->parent_joint->type, urdf::Joint::FIXED);
  EXPECT_EQ(model->getLink("tool")->inertial->mass, roundedForExport(goldenPayload()).mass);
}

TEST(ExportFormats, UrdfIsTakenByUrdfdom) {
  const auto model = urdf::parseURDF(exported("urdf", goldenInput()));
  ASSERT_TRUE(model);
  EXPECT_EQ(model->getName(), goldenInput().name);
  const auto inertial = model->getRoot()->inertial;
  ASSERT_TRUE(inertial);
  const Payload payload = roundedForExport(goldenPayload());
  EXPECT_EQ(inertial->mass, payload.mass);
  EXPECT_EQ(inertial->origin.position.y, payload.com.y());
  EXPECT_EQ(inertial->ixy, payload.inertiaCom(0, 1));
  EXPECT_EQ(inertial->iyz, payload.inertiaCom(1, 2));
  EXPECT_EQ(inertial->izz, payload.inertiaCom(2, 2));
}

TEST(ExportFormats, AxisAlignedTensorsNeedNoTurning) {
  ExportInput input;
  input.payload = {1.0, {0.0, 0.0, 0.1}, Vector3d(0.003, 0.001, 0.002).asDiagonal()};
  EXPECT_NE(exported("kuka", input).find("A 0,B 0,C 0},J {X 0.003,Y 0.001,Z 0.002}"), std::string::npos);
  EXPECT_NE(exported("abb", input).find("[1,[0,0,100],[1,0,0,0],0.003,0.001,0.002]"), std::string::npos);
  EXPECT_NE(exported("ur", input).find("set_target_payload(1, [0, 0, 0.1], [0.003, 0.001, 0.002, 0, 0, 0], 0)"),
            std::string::npos);
  EXPECT_NE(exported("fanuc", input).find("PAYLOAD INERTIA Y [kgf cm s2] = 0.010197"), std::string::npos);
}

}  // namespace
}  // namespace heft
