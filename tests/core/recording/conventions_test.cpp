// Reading and writing the convention keys; what they do to numbers is in tests/core/motion/sensor_axes_test.cpp.
#include "core/recording/conventions.h"

#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/json_file.h"
#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

Result<RecordingMeta> metaOf(const json& root) {
  Findings findings;
  auto meta = parseMeta(root.dump(), "rec.meta.json", ".", findings);
  EXPECT_TRUE(findings.empty()) << allLines(findings);
  return meta;
}

const json kAll = {{"sensor",
                    {{"wrench_axes", "base"},
                     {"wrench_point", {0.0, 0.01, -0.2}},
                     {"torque_sign", "opposite"},
                     {"wrench_order", "torque_first"},
                     {"mirrored_axis", "y"},
                     {"force_unit", "lbf"},
                     {"torque_unit", 0.25}}},
                   {"angle_unit", "deg"},
                   {"length_unit", "mm"},
                   {"pose", "base_in_sensor"},
                   {"quaternion_order", "wxyz"}};

TEST(ConventionKeys, AllAreReadAndWrittenBack) {
  const auto meta = metaOf(kAll);
  ASSERT_TRUE(meta) << meta.error().message;
  const Conventions& c = meta->conventions;
  EXPECT_EQ(c.wrenchAxes, Conventions::WrenchAxes::base);
  EXPECT_EQ(c.wrenchPoint.kind, Conventions::WrenchPoint::Kind::offset);
  EXPECT_EQ(c.wrenchPoint.offset, Vector3d(0.0, 0.01, -0.2));
  EXPECT_EQ(c.torqueSign, Conventions::TorqueSign::opposite);
  EXPECT_EQ(c.wrenchOrder, Conventions::WrenchOrder::torqueFirst);
  EXPECT_EQ(c.mirroredAxis, 1);
  EXPECT_EQ(c.force.name, "lbf");
  EXPECT_DOUBLE_EQ(c.force.si, 4.4482216152605);
  EXPECT_EQ(c.torque.name, "");
  EXPECT_EQ(c.torque.si, 0.25);
  EXPECT_DOUBLE_EQ(c.radPerAngle, std::numbers::pi / 180.0);
  EXPECT_EQ(c.mPerLength, 1e-3);
  EXPECT_EQ(c.pose, Conventions::PoseDirection::baseInSensor);
  EXPECT_EQ(c.quaternionOrder, Conventions::QuaternionOrder::wxyz);
  EXPECT_EQ(metaPatch(c), kAll);
  json flat = kAll["sensor"];
  for (const auto& [key, value] : kAll.items())
    if (key != "sensor") flat[key] = value;
  EXPECT_EQ(toJson(c), flat);
}

TEST(ConventionKeys, WhatIsPlainIsNotWritten) {
  const json plain = {{"sensor",
                       {{"wrench_axes", "sensor"},
                        {"wrench_point", "sensor"},
                        {"torque_sign", "as_force"},
                        {"wrench_order", "force_first"},
                        {"mirrored_axis", nullptr},
                        {"force_unit", "N"},
                        {"torque_unit", 1}}},
                      {"angle_unit", "rad"},
                      {"length_unit", "m"},
                      {"pose", "sensor_in_base"},
                      {"quaternion_order", nullptr}};
  const auto meta = metaOf(plain);
  ASSERT_TRUE(meta) << meta.error().message;
  EXPECT_TRUE(meta->conventions.plain());
  EXPECT_EQ(toJson(meta->conventions), json::object());
  EXPECT_EQ(metaPatch(meta->conventions), json::object());
  EXPECT_TRUE(metaOf({{"sensor", {{"wrench_point", {0, 0, 0}}}}})->conventions.plain());
}

TEST(ConventionKeys, UnitsAreKnownByTheirNames) {
  const std::pair<const char*, double> torques[] = {{"N m", 1.0},
                                                    {"Nm", 1.0},
                                                    {"N*mm", 1e-3},
                                                    {"N cm", 1e-2},
                                                    {"kgf cm", 0.0980665},
                                                    {"kgf m", 9.80665},
                                                    {"lbf in", 0.1129848290276167},
                                                    {"lbf-ft", 1.3558179483314004}};
  for (const auto& [name, si] : torques) {
    const auto meta = metaOf({{"sensor", {{"torque_unit", name}}}});
    ASSERT_TRUE(meta) << meta.error().message;
    EXPECT_DOUBLE_EQ(meta->conventions.torque.si, si) << name;
  }
}

TEST(ConventionKeys, AWrongValueIsSaidWithItsPath) {
  const std::pair<json, std::string> cases[] = {
      {{{"sensor", {{"wrench_axes", "tool"}}}},
       R"(rec.meta.json: sensor.wrench_axes: must be "sensor" or "base", not "tool".)"},
      {{{"sensor", {{"wrench_point", {1, 2}}}}}, "sensor.wrench_point: must be \"sensor\", \"base\" or three numbers"},
      {{{"sensor", {{"wrench_point", {0, 0, 60}}}}}, "metres, not millimetres"},
      {{{"sensor", {{"torque_sign", -1}}}}, "sensor.torque_sign: must be \"as_force\" or \"opposite\", not -1."},
      {{{"sensor", {{"wrench_order", true}}}}, "sensor.wrench_order: must be"},
      {{{"sensor", {{"mirrored_axis", "w"}}}}, R"(sensor.mirrored_axis: must be null, "x", "y" or "z", not "w".)"},
      {{{"sensor", {{"force_unit", "pound"}}}}, "sensor.force_unit: must be \"N\", \"kN\""},
      {{{"sensor", {{"torque_unit", 0}}}}, "sensor.torque_unit: must be \"N m\""},
      {{{"sensor", {{"torque_unit", -2.5}}}}, "not -2.5."},
      {{{"angle_unit", "grad"}}, R"(rec.meta.json: angle_unit: must be "rad" or "deg", not "grad".)"},
      {{{"length_unit", 1}}, "length_unit: must be"},
      {{{"pose", "flange"}}, R"(pose: must be "sensor_in_base" or "base_in_sensor", not "flange".)"},
      {{{"quaternion_order", "wzyx"}}, "quaternion_order: must be"}};
  for (const auto& [root, expected] : cases) {
    const auto meta = metaOf(root);
    ASSERT_FALSE(meta) << root;
    EXPECT_THAT(meta.error().message, HasSubstr(expected));
  }
}

TEST(ConventionKeys, WhatAMapFileStatesCountsMore) {
  Conventions conventions = metaOf(kAll)->conventions;
  const auto stated = readConventions(
      {{"sensor", {{"mirrored_axis", nullptr}, {"torque_sign", "as_force"}}}, {"angle_unit", "rad"}, {"pose", nullptr}},
      "rec.map.json");
  ASSERT_TRUE(stated);
  EXPECT_EQ(stated->keys, (std::set<std::string>{"mirrored_axis", "torque_sign", "angle_unit"}));
  takeOver(*stated, conventions);
  EXPECT_FALSE(conventions.mirroredAxis);
  EXPECT_EQ(conventions.torqueSign, Conventions::TorqueSign::asForce);
  EXPECT_EQ(conventions.radPerAngle, 1.0);
  EXPECT_EQ(conventions.pose, Conventions::PoseDirection::baseInSensor) << "not stated";
  EXPECT_EQ(conventions.force.name, "lbf");
  const auto again = readConventions(metaPatch(*stated), "again");
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, *stated);
}

TEST(ConventionKeys, APatchTakesAwayWhatIsPlainAgain) {
  const Conventions before = metaOf(kAll)->conventions;
  Conventions after = before;
  after.mPerLength = 1.0;
  after.torqueSign = Conventions::TorqueSign::asForce;
  after.force = {"kgf", 9.80665};
  EXPECT_EQ(metaPatch(before, after),
            json({{"sensor", {{"torque_sign", nullptr}, {"force_unit", "kgf"}}}, {"length_unit", nullptr}}));
  json merged = kAll;
  merged.merge_patch(metaPatch(before, after));
  EXPECT_EQ(metaOf(merged)->conventions, after);
}

TEST(ConventionKeys, ColumnsMayNameTheStatedUnit) {
  auto table = goodTable(Form::joints);
  for (int j = 1; j <= 7; ++j) {
    table.scaleColumn(fmt::format("q{}", j), 180.0 / std::numbers::pi);
    table.names[static_cast<std::size_t>(j)] = fmt::format("q{} [deg]", j);
  }
  EXPECT_THAT(failureOf(table.text()), AllOf(HasSubstr("not in SI units"), HasSubstr("state the unit")));
  RecordingMeta meta = pandaMeta();
  meta.conventions.radPerAngle = std::numbers::pi / 180.0;
  const auto read = parse(table.text(), meta);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_LT((read->recording.q - parse(goodTable(Form::joints).text())->recording.q).cwiseAbs().maxCoeff(), 1e-12);
  table.names[8] = "fx [counts]";
  EXPECT_FALSE(parse(table.text(), meta)) << "a remark, and so another column";
  meta.conventions.force = {"", 0.001};
  EXPECT_TRUE(parse(table.text(), meta));
  table.names[1] = "q1 [rad]";
  EXPECT_THAT(failureOf(table.text(), meta), HasSubstr("another unit than the one stated, deg"));
}

TEST(ConventionKeys, ATwistBesideAnInvertedPoseIsLeftAside) {
  RecordingMeta meta;
  meta.conventions.pose = Conventions::PoseDirection::baseInSensor;
  const auto read = parse(goodTable(Form::pose, 200, true).text(), meta);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->recording.twist.rows(), 0);
  EXPECT_NE(findCode(read->findings, "columns_set_aside"), nullptr);
}

TEST(ConventionKeys, AFileIsWrittenInThePlainForm) {
  const auto folder = std::filesystem::temp_directory_path() / "heft_conventions_written";
  std::filesystem::create_directories(folder);
  RecordingMeta meta = pandaMeta();
  meta.conventions.torque = {"N mm", 1e-3};
  meta.conventions.mirroredAxis = 0;
  const auto read = parse(goodTable(Form::joints).text(), meta);
  ASSERT_TRUE(read);
  ASSERT_TRUE(writeRecording(read->recording, folder / "rec.csv"));
  EXPECT_FALSE((*readJsonFile(folder / "rec.meta.json"))["sensor"].contains("torque_unit"));
  const auto again = readRecording(folder / "rec.csv");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->recording.wrench, read->recording.wrench);
  EXPECT_TRUE(again->recording.meta.conventions.plain());
  // A live recording's meta goes to disk before its numbers, which are those of the source.
  ASSERT_TRUE(writeMeta(meta, folder / "live.meta.json"));
  Findings findings;
  EXPECT_EQ(readMeta(folder / "live.meta.json", findings)->conventions, meta.conventions);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace heft
