#include <filesystem>

#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

Result<RecordingMeta> meta(const std::string& text, Findings& findings) {
  return parseMeta(text, "rec.meta.json", "/data", findings);
}

std::string failureOfMeta(const std::string& text) {
  Findings findings;
  const auto result = meta(text, findings);
  return result ? "(was read without failure)" : result.error().message;
}

TEST(Meta, EveryKeyIsRead) {
  Findings findings;
  const auto result = meta(R"({
    "robot": "arms/ur.urdf", "kind": "poses",
    "sensor": {"mount": {"parent": "tool0", "xyz_m": [0.01, 0, 0.1], "rpy_rad": [0, 0, -0.7853981633974483]},
               "model": "Gamma", "wrench_sign": "payload_on_sensor"},
    "gravity_m_s2": [0, 0, -9.82],
    "known_payload": {"mass_kg": 0.5, "com_m": [0, 0, 0.05], "inertia_com_kgm2": [[1e-3,0,0],[0,1e-3,0],[0,0,1e-3]]},
    "marks": [{"from_s": 1, "to_s": 2.5, "label": "free"}, {"from_s": 2.5, "to_s": 3, "label": "contact"}],
    "note": "tried twice"})",
                           findings);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(allLines(findings), "");
  EXPECT_EQ(result->robot, "/data/arms/ur.urdf");
  EXPECT_EQ(result->kind, RecordingKind::poses);
  EXPECT_EQ(result->mount.parent, "tool0");
  EXPECT_EQ(result->mount.xyz, Vector3d(0.01, 0, 0.1));
  EXPECT_EQ(result->mount.rpy.z(), -0.7853981633974483);
  EXPECT_EQ(result->sensorModel, "Gamma");
  EXPECT_EQ(result->wrenchSign, WrenchSign::payloadOnSensor);
  EXPECT_EQ(result->gravity, Vector3d(0, 0, -9.82));
  EXPECT_EQ(result->knownPayload.mass, 0.5);
  EXPECT_EQ((*result->knownPayload.inertiaCom)(1, 1), 1e-3);
  ASSERT_EQ(result->marks.size(), 2u);
  EXPECT_EQ(result->marks[0].to, 2.5);
  EXPECT_EQ(result->marks[1].label, MarkLabel::contact);
  EXPECT_EQ(result->note, "tried twice");
}

TEST(Meta, AbsentAndNullMeanDefaults) {
  for (
      const char* text :
      {"{}",
       R"({"robot": null, "kind": null, "sensor": null, "gravity_m_s2": null, "known_payload": null, "marks": null, "note": null})",
       R"({"sensor": {"mount": null, "model": null, "wrench_sign": null}, "known_payload": {"mass_kg": null}})"}) {
    Findings findings;
    const auto result = meta(text, findings);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(allLines(findings), "");
    EXPECT_EQ(result->robot, std::nullopt);
    EXPECT_EQ(result->kind, RecordingKind::motion);
    EXPECT_EQ(result->wrenchSign, WrenchSign::sensorOnPayload);
    EXPECT_EQ(result->gravity, Vector3d(0, 0, -9.81));
    EXPECT_TRUE(result->knownPayload.empty());
  }
}

TEST(Meta, RobotPaths) {
  Findings findings;
  EXPECT_EQ(meta(R"({"robot": "panda"})", findings)->robot, "panda");
  EXPECT_EQ(meta(R"({"robot": "/abs/arm.urdf"})", findings)->robot, "/abs/arm.urdf");
  EXPECT_EQ(meta(R"({"robot": "../arm.urdf"})", findings)->robot, "/arm.urdf");
  EXPECT_THAT(failureOfMeta(R"({"robot": "fanuc"})"), HasSubstr("rec.meta.json: robot: "));
  EXPECT_THAT(failureOfMeta(R"({"robot": "arm.urdf.xacro"})"), HasSubstr("xacro"));
  EXPECT_THAT(failureOfMeta(R"({"robot": "package://nobodys_arm/urdf/arm.urdf"})"),
              testing::AllOf(HasSubstr("rec.meta.json: robot: \"package://nobodys_arm/urdf/arm.urdf\" was not found"),
                             HasSubstr("AMENT_PREFIX_PATH")));
}

TEST(Meta, WrongValuesAreNamedWithTheirPath) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"([1])", "rec.meta.json: a setup file must be"},
      {R"({"robot": 7})", "rec.meta.json: robot: must be a text, not 7"},
      {R"({"robot": ""})", "rec.meta.json: robot: "},
      {R"({"kind": "pose"})", "rec.meta.json: kind: must be \"motion\" or \"poses\", not \"pose\""},
      {R"({"sensor": []})", "rec.meta.json: sensor: "},
      {R"({"sensor": {"wrench_sign": "up"}})", "rec.meta.json: sensor.wrench_sign: must be"},
      {R"({"sensor": {"wrench_sign": 1}})", "rec.meta.json: sensor.wrench_sign: must be"},
      {R"({"sensor": {"model": 1}})", "rec.meta.json: sensor.model: "},
      {R"({"sensor": {"mount": 1}})", "rec.meta.json: sensor.mount: "},
      {R"({"sensor": {"mount": {"parent": 3}}})", "rec.meta.json: sensor.mount.parent: "},
      {R"({"sensor": {"mount": {"xyz_m": [1, 2]}}})", "rec.meta.json: sensor.mount.xyz_m: must be three numbers"},
      {R"({"sensor": {"mount": {"xyz_m": [0, 0, 107]}}})", "rec.meta.json: sensor.mount.xyz_m: "},
      {R"({"sensor": {"mount": {"rpy_rad": [0, 0, -45]}}})", "rec.meta.json: sensor.mount.rpy_rad: "},
      {R"({"sensor": {"mount": {"rpy_rad": ["a", 0, 0]}}})", "rec.meta.json: sensor.mount.rpy_rad: "},
      {R"({"gravity_m_s2": 9.81})", "rec.meta.json: gravity_m_s2: "},
      {R"({"gravity_m_s2": [0, 0, -9810]})", "rec.meta.json: gravity_m_s2: "},
      {R"({"known_payload": 0.5})", "rec.meta.json: known_payload: "},
      {R"({"known_payload": {"mass_kg": -0.5}})", "rec.meta.json: known_payload: mass_kg"},
      {R"({"known_payload": {"mass_kg": "0.5"}})", "rec.meta.json: known_payload: mass_kg"},
      {R"({"known_payload": {"com_m": [1]}})", "rec.meta.json: known_payload: com_m"},
      {R"({"known_payload": {"com_m": [0, 0, 43.9]}})", "rec.meta.json: known_payload.com_m: "},
      {R"({"known_payload": {"inertia_com_kgm2": [1, 2, 3]}})", "rec.meta.json: known_payload: inertia_com_kgm2"},
      {R"({"marks": {}})", "rec.meta.json: marks: "},
      {R"({"marks": [3]})", "rec.meta.json: marks[0]: "},
      {R"({"marks": [{"from_s": 1, "label": "free"}]})", "rec.meta.json: marks[0].to_s: is missing"},
      {R"({"marks": [{"from_s": "1", "to_s": 2, "label": "free"}]})", "rec.meta.json: marks[0].from_s: "},
      {R"({"marks": [{"from_s": 3, "to_s": 2, "label": "free"}]})", "rec.meta.json: marks[0]: ends at 2 s"},
      {R"({"marks": [{"from_s": 1, "to_s": 2}]})", "rec.meta.json: marks[0].label: is missing"},
      {R"({"marks": [{"from_s": 1, "to_s": 2, "label": "x"}]})", "rec.meta.json: marks[0].label: must be"},
      {R"({"note": 5})", "rec.meta.json: note: "},
      {"{\n \"kind\": motion\n}", "rec.meta.json:2:"},
      {R"({"gravity_m_s2": [0, 0, NaN]})", "rec.meta.json:1:"},
      {R"({"gravity_m_s2": [0, 0, -1e999]})", "rec.meta.json: "},
  };
  for (const auto& [text, expected] : cases) EXPECT_THAT(failureOfMeta(text), StartsWith(expected)) << text;
}

TEST(Meta, UnknownKeysAreInformation) {
  Findings findings;
  ASSERT_TRUE(meta(
      R"({"robo": "panda", "sensor": {"sign": 1, "mount": {"xyz": [0,0,0]}}, "marks": [{"from_s": 0, "to_s": 1, "label": "free", "who": 1}]})",
      findings));
  ASSERT_EQ(findings.size(), 4u) << allLines(findings);
  std::string all = allLines(findings);
  for (const char* path : {"robo: ", "sensor.sign: ", "sensor.mount.xyz: ", "marks[0].who: "})
    EXPECT_THAT(all, HasSubstr(std::string("rec.meta.json: ") + path));
  for (const auto& finding : findings) EXPECT_EQ(finding.severity, Severity::info);
}

TEST(Meta, OddButPossibleValuesAreWarnings) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"({"gravity_m_s2": [0, 0, -1.62]})", "gravity_unusual"},
      {R"({"gravity_m_s2": [0, 0, 9.81]})", "gravity_points_up"},
      {R"({"known_payload": {"mass_kg": 930}})", "known_mass_large"},
      {R"({"known_payload": {"mass_kg": 1, "com_m": [0,0,0], "inertia_com_kgm2": [[1e-3,0,0],[0,1e-3,0],[0,0,5e-3]]}})",
       "known_payload_unphysical"},
      {R"({"marks": [{"from_s": 0, "to_s": 2, "label": "free"}, {"from_s": 1, "to_s": 3, "label": "contact"}]})",
       "marks_overlap"},
  };
  for (const auto& [text, code] : cases) {
    Findings findings;
    ASSERT_TRUE(meta(text, findings)) << text;
    ASSERT_EQ(findings.size(), 1u) << text << "\n" << allLines(findings);
    EXPECT_EQ(findings[0].code, code);
    EXPECT_EQ(findings[0].severity, Severity::warning);
    EXPECT_FALSE(findings[0].remedy.empty());
  }
}

TEST(Meta, HostileNestingDoesNoHarm) {
  std::string deep = "{\"known_payload\": ";
  for (int i = 0; i < 100000; ++i) deep += "{\"payload\": ";
  EXPECT_THAT(failureOfMeta(deep + "1" + std::string(100001, '}')), HasSubstr("nested"));
}

}  // namespace
}  // namespace heft
