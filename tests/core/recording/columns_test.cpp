// Defects of the header.
#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Columns, MissingOnesAreAllNamed) {
  auto table = goodTable(Form::pose);
  table.removeColumn("fy");
  EXPECT_THAT(failureOf(table.text()),
              AllOf(StartsWith("rec.csv:1: "), HasSubstr("column fy is missing"), HasSubstr("header has: time")));
  table.removeColumn("tz");
  table.removeColumn("time");
  EXPECT_THAT(failureOf(table.text()), HasSubstr("columns time, fy, tz are missing"));
}

TEST(Columns, WithNeitherMotionFormBothAreNamed) {
  auto table = goodTable(Form::orientation);
  for (const char* name : {"qx", "qy", "qz", "qw"}) table.removeColumn(name);
  EXPECT_THAT(failureOf(table.text()),
              AllOf(HasSubstr("q1..q7"), HasSubstr("qx, qy, qz, qw"), HasSubstr("px, py, pz")));
  table.removeColumn("fz");
  EXPECT_THAT(failureOf(table.text()), AllOf(HasSubstr("column fz is missing, and"), HasSubstr("q1..q7")));
}

TEST(Columns, PositionAloneIsNoMotion) {
  auto table = goodTable(Form::pose);
  for (const char* name : {"qx", "qy", "qz", "qw"}) table.removeColumn(name);
  EXPECT_THAT(failureOf(table.text()), AllOf(HasSubstr("q1..q7"), HasSubstr("qx, qy, qz, qw")));
}

TEST(Columns, IncompleteMotionNamesWhatLacks) {
  auto joints = goodTable(Form::joints);
  joints.removeColumn("q3");
  EXPECT_THAT(failureOf(joints.text()), HasSubstr("column q3 is missing"));
  auto last = goodTable(Form::joints);
  last.removeColumn("q7");
  EXPECT_THAT(failureOf(last.text()), HasSubstr("column q7 is missing"));
  auto quaternion = goodTable(Form::orientation);
  quaternion.removeColumn("qw");
  EXPECT_THAT(failureOf(quaternion.text()), HasSubstr("column qw is missing"));
  auto position = goodTable(Form::pose);
  position.removeColumn("py");
  EXPECT_THAT(failureOf(position.text()), HasSubstr("column py is missing"));
}

TEST(Columns, IncompleteSecondFormIsSetAside) {
  auto table = goodTable(Form::joints);
  table.addColumn("qx", "0");
  table.addColumn("qy", "0");
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_FALSE(result->recording.hasOrientation());
  const auto* finding = findCode(result->findings, "columns_set_aside");
  ASSERT_NE(finding, nullptr);
  EXPECT_THAT(finding->text, HasSubstr("qz, qw"));
  EXPECT_EQ(result->recording.extra.size(), 2u) << "kept for writing back";

  auto pose = goodTable(Form::pose);
  pose.addColumn("q1", "0");
  const auto posed = parse(pose.text());
  ASSERT_TRUE(posed) << posed.error().message;
  EXPECT_FALSE(posed->recording.hasJoints());
  EXPECT_NE(findCode(posed->findings, "columns_set_aside"), nullptr);
}

TEST(Columns, IncompleteRatesAreSetAside) {
  auto joints = goodTable(Form::joints, 100, true);
  joints.removeColumn("dq4");
  const auto result = parse(joints.text());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->recording.dq.rows(), 0);
  EXPECT_NE(findCode(result->findings, "columns_set_aside"), nullptr);
  auto pose = goodTable(Form::pose, 100, true);
  pose.removeColumn("wy");
  const auto posed = parse(pose.text());
  ASSERT_TRUE(posed);
  EXPECT_EQ(posed->recording.twist.rows(), 0);
}

TEST(Columns, DuplicatesNameBothFields) {
  auto table = goodTable(Form::joints);
  table.addColumn("fx");
  EXPECT_THAT(failureOf(table.text()),
              AllOf(StartsWith("rec.csv:1:15: "), HasSubstr("column fx appears twice: also as column 9")));
  auto loose = goodTable(Form::joints);
  loose.names[loose.column("q2")] = "Q2";
  loose.addColumn("q2 [rad]");
  EXPECT_THAT(failureOf(loose.text()), HasSubstr("twice"));
}

TEST(Columns, ForeignUnitsInNamesAreErrors) {
  for (const auto& [name, unit] : {std::pair("q4", "deg"), std::pair("q4", "°"), std::pair("fz", "kN"),
                                   std::pair("tx", "Nmm"), std::pair("time", "ms")}) {
    auto table = goodTable(Form::joints);
    const auto field = table.column(name);
    table.names[field] = fmt::format("{} [{}]", name, unit);
    EXPECT_THAT(failureOf(table.text()),
                AllOf(StartsWith(fmt::format("rec.csv:1:{}: ", field + 1)), HasSubstr("not in SI units")))
        << name << unit;
  }
}

TEST(Columns, RemarksInBracketsMakeAnotherColumn) {
  auto table = goodTable(Form::joints);
  table.addColumn("fx (raw)", "7");
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->recording.extra.size(), 1u);
}

TEST(Columns, NumbersInPlaceOfTheHeader) {
  auto table = goodTable(Form::joints);
  table.names = table.rows.front();
  EXPECT_THAT(failureOf(table.text()),
              AllOf(StartsWith("rec.csv:1: "), HasSubstr("looks like data"), HasSubstr("header")));
}

TEST(Columns, StrangeJointNamesAreUnknown) {
  auto table = goodTable(Form::joints);
  for (const char* name : {"q0", "q01", "q999999999999", "q", "dq", "q1x", "q-1", "q1.5"}) table.addColumn(name);
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->recording.extra.size(), 8u);
  EXPECT_EQ(result->recording.q.cols(), 7);
}

TEST(Columns, NamesThatAreNotUtf8AreShownSafely) {
  auto table = goodTable(Form::joints);
  table.addColumn("Temp\xE9rature\x01");
  const auto result = parse(table.text());
  ASSERT_TRUE(result);
  EXPECT_THAT(findCode(result->findings, "unknown_columns")->text, HasSubstr("Temp\uFFFDrature\uFFFD"));
  EXPECT_EQ(result->recording.extra[0].name, "Temp\xE9rature\x01") << "kept byte for byte";
}

TEST(Columns, TooManyAreRefused) {
  EXPECT_THAT(failureOf("time" + std::string(200000, ',') + "\n"), HasSubstr("more than 10000 columns"));
  EXPECT_THAT(failureOf(std::string(3 << 20, 'x') + "\n"), HasSubstr("not a header"));
}

}  // namespace
}  // namespace heft
