// What is read without complaint: every motion form, separators, quoting, line ends.
#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::HasSubstr;

TEST(AcceptedForms, GoodTablesRaiseNoFindings) {
  for (const auto form : {Form::joints, Form::pose, Form::orientation})
    for (const bool rates : {false, true}) {
      const auto result = parse(goodTable(form, 200, rates).text());
      ASSERT_TRUE(result) << result.error().message;
      EXPECT_EQ(allLines(result->findings), "");
      EXPECT_EQ(result->recording.rows(), 200);
      EXPECT_NEAR(result->recording.rateHz(), 100.0, 1e-6);
      EXPECT_NEAR(result->recording.duration(), 1.99, 1e-12);
    }
}

TEST(AcceptedForms, JointsLandInTheirColumns) {
  auto table = goodTable(Form::joints, 50, true);
  const auto result = parse(table.text());
  ASSERT_TRUE(result);
  const auto& recording = result->recording;
  EXPECT_TRUE(recording.hasJoints());
  EXPECT_FALSE(recording.hasOrientation());
  EXPECT_FALSE(recording.hasPosition());
  ASSERT_EQ(recording.q.cols(), 7);
  ASSERT_EQ(recording.dq.cols(), 7);
  for (const std::size_t row : {0u, 17u, 49u}) {
    for (int j = 0; j < 7; ++j) {
      EXPECT_EQ(recording.q(static_cast<int>(row), j), table.number(row, fmt::format("q{}", j + 1)));
      EXPECT_EQ(recording.dq(static_cast<int>(row), j), table.number(row, fmt::format("dq{}", j + 1)));
    }
    EXPECT_EQ(recording.wrench(static_cast<int>(row), 2), table.number(row, "fz"));
    EXPECT_EQ(recording.wrench(static_cast<int>(row), 3), table.number(row, "tx"));
  }
}

TEST(AcceptedForms, PosesLandInTheirColumns) {
  auto table = goodTable(Form::pose, 50, true);
  const auto result = parse(table.text());
  ASSERT_TRUE(result);
  const auto& recording = result->recording;
  EXPECT_EQ(recording.position(7, 1), table.number(7, "py"));
  EXPECT_NEAR(recording.quaternion(7, 3), table.number(7, "qw"), 1e-15);
  EXPECT_NEAR(recording.quaternion(7, 0), table.number(7, "qx"), 1e-15);
  EXPECT_EQ(recording.twist(7, 5), table.number(7, "wz"));
}

TEST(AcceptedForms, OrientationAloneHasNoPosition) {
  const auto result = parse(goodTable(Form::orientation).text());
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->recording.hasOrientation());
  EXPECT_FALSE(result->recording.hasPosition());
}

TEST(AcceptedForms, ColumnsInAnyOrder) {
  auto table = goodTable(Form::joints, 30);
  const auto straight = parse(table.text());
  std::reverse(table.names.begin(), table.names.end());
  for (auto& row : table.rows) std::reverse(row.begin(), row.end());
  const auto reversed = parse(table.text());
  ASSERT_TRUE(straight);
  ASSERT_TRUE(reversed);
  EXPECT_EQ(straight->recording.q, reversed->recording.q);
  EXPECT_EQ(straight->recording.wrench, reversed->recording.wrench);
  EXPECT_EQ(straight->recording.time, reversed->recording.time);
}

TEST(AcceptedForms, SeparatorsAndLineEnds) {
  const auto table = goodTable(Form::pose, 40);
  const auto expected = parse(table.text());
  ASSERT_TRUE(expected);
  for (const std::string separator : {",", ";", "\t", " , ", " ;  "})
    for (const std::string newline : {"\n", "\r\n", "\r"}) {
      const auto result = parse(table.text(separator, newline));
      ASSERT_TRUE(result) << "separator '" << separator << "': " << result.error().message;
      EXPECT_EQ(result->recording.wrench, expected->recording.wrench);
      EXPECT_EQ(result->recording.quaternion, expected->recording.quaternion);
      EXPECT_EQ(allLines(result->findings), "");
    }
}

TEST(AcceptedForms, MarksOfEditorsAndSpreadsheets) {
  auto table = goodTable(Form::orientation, 40);
  const auto expected = parse(table.text());
  const auto same = [&](const std::string& text, const char* what) {
    const auto result = parse(text);
    ASSERT_TRUE(result) << what << ": " << result.error().message;
    EXPECT_EQ(result->recording.wrench, expected->recording.wrench) << what;
    EXPECT_EQ(result->recording.rows(), 40) << what;
    EXPECT_EQ(allLines(result->findings), "") << what;
  };
  same("\xEF\xBB\xBF" + table.text(), "byte order mark");
  same(table.text() + "\n\n  \r\n\t\n", "trailing empty lines");
  same("\n\n" + table.text(), "leading empty lines");
  auto text = table.text();
  text.pop_back();
  same(text, "no line break at the end");
  auto quoted = table;
  for (auto& name : quoted.names) name = "\"" + name + "\"";
  same(quoted.text(), "quoted header");
  for (auto& row : quoted.rows)
    for (auto& cell : row) cell = " \"" + cell + "\" ";
  same(quoted.text(), "quoted cells");
  auto trailing = table;
  trailing.names.back() += ",";
  for (auto& row : trailing.rows) row.back() += ",";
  same(trailing.text(), "separator at the end of every line");
  trailing.names.back().pop_back();
  same(trailing.text(), "separator at the end of every row but the header");
}

TEST(AcceptedForms, LooseNamesAreReadAndSaid) {
  auto table = goodTable(Form::joints, 40);
  table.names[0] = "Time [s]";
  table.names[table.column("fx")] = "FX (N)";
  table.names[table.column("tz")] = "tz [N·m]";
  table.names[table.column("q1")] = "Q1[rad]";
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  const auto* finding = findCode(result->findings, "names_normalised");
  ASSERT_NE(finding, nullptr);
  EXPECT_THAT(finding->text, HasSubstr("\"FX (N)\" as fx"));
  EXPECT_EQ(findCode(result->findings, "unknown_columns"), nullptr);
}

TEST(AcceptedForms, ExactNameWinsOverLooseOne) {
  auto table = goodTable(Form::joints, 40);
  table.addColumn("Fx", "77");
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_NE(result->recording.wrench(0, 0), 77.0);
  ASSERT_EQ(result->recording.extra.size(), 1u);
}

TEST(AcceptedForms, UnknownColumnsAreKeptAsTheyStood) {
  auto table = goodTable(Form::joints, 40);
  table.addColumn("note");
  for (std::size_t r = 0; r < table.rows.size(); ++r) table.cell(r, "note") = fmt::format("\"a, \"\"{}\"\"\"", r);
  table.addColumn("temp", "21.50");
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->recording.extra.size(), 2u);
  EXPECT_EQ(result->recording.extra[0].name, "note");
  EXPECT_EQ(result->recording.extra[0].cells[3], "a, \"3\"");
  EXPECT_EQ(result->recording.extra[1].cells[39], "21.50");
  const auto* finding = findCode(result->findings, "unknown_columns");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->severity, Severity::info);
  EXPECT_THAT(finding->text, HasSubstr("note, temp"));
  EXPECT_EQ(finding->where.column, 15);
}

TEST(AcceptedForms, WrenchSignIsTurnedToSensorOnPayload) {
  auto table = goodTable(Form::pose, 40);
  auto meta = pandaMeta();
  const auto plain = parse(table.text(), meta);
  meta.wrenchSign = WrenchSign::payloadOnSensor;
  const auto turned = parse(table.text(), meta);
  ASSERT_TRUE(plain);
  ASSERT_TRUE(turned);
  EXPECT_EQ(plain->recording.wrench(5, 2), table.number(5, "fz"));
  EXPECT_EQ(turned->recording.wrench, -plain->recording.wrench);
}

TEST(AcceptedForms, LabelsAreRead) {
  auto table = goodTable(Form::pose, 40);
  table.addColumn("label", "");
  table.cell(3, "label") = "free";
  table.cell(4, "label") = "contact";
  table.cell(5, "label") = " ignore ";
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->recording.labels.size(), 40u);
  EXPECT_EQ(result->recording.labels[3], MarkLabel::free);
  EXPECT_EQ(result->recording.labels[4], MarkLabel::contact);
  EXPECT_EQ(result->recording.labels[5], MarkLabel::ignore);
  EXPECT_EQ(result->recording.labels[6], std::nullopt);
  EXPECT_EQ(allLines(result->findings), "");
  EXPECT_TRUE(result->recording.extra.empty());
}

TEST(AcceptedForms, UnknownLabelIsSaid) {
  auto table = goodTable(Form::pose, 40);
  table.addColumn("label", "free");
  table.cell(3, "label") = "touching";
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  const auto* finding = findCode(result->findings, "label_unknown");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->where.line, 5);
  EXPECT_EQ(result->recording.labels[3], std::nullopt);
}

TEST(AcceptedForms, StandingPosesNeedNoTime) {
  auto meta = pandaMeta();
  meta.kind = RecordingKind::poses;
  for (const std::string time : {"0", "", "abc?"}) {
    auto table = goodTable(Form::orientation, 24);
    if (time == "abc?")
      table.removeColumn("time");
    else
      table.setColumn("time", time);
    const auto result = parse(table.text(), meta);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->recording.rows(), 24);
    EXPECT_EQ(result->recording.time(23), 23.0);
    EXPECT_NE(findCode(result->findings, "time_replaced"), nullptr);
  }
  auto falling = goodTable(Form::orientation, 24);
  std::swap(falling.cell(3, "time"), falling.cell(9, "time"));
  EXPECT_TRUE(parse(falling.text(), meta));
  EXPECT_FALSE(parse(falling.text()));
}

TEST(AcceptedForms, RisingTimeOfStandingPosesStays) {
  auto meta = pandaMeta();
  meta.kind = RecordingKind::poses;
  auto table = goodTable(Form::orientation, 24);
  table.scaleColumn("time", 12345.0);
  const auto result = parse(table.text(), meta);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->recording.time(5), table.number(5, "time"));
  EXPECT_EQ(allLines(result->findings), "");
}

TEST(AcceptedForms, JointsWithoutRobotAreTakenForAPanda) {
  const auto result = parse(goodTable(Form::joints).text(), RecordingMeta{});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->recording.meta.robot, "panda");
  ASSERT_NE(findCode(result->findings, "robot_assumed"), nullptr);
  EXPECT_EQ(findCode(result->findings, "robot_assumed")->severity, Severity::warning);
  const auto pose = parse(goodTable(Form::pose).text(), RecordingMeta{});
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->recording.meta.robot, std::nullopt);
}

TEST(AcceptedForms, OtherArmsMayHaveOtherJointCounts) {
  auto table = goodTable(Form::joints);
  table.removeColumn("q7");
  RecordingMeta meta;
  EXPECT_THAT(failureOf(table.text(), meta), HasSubstr("6 joints but no robot is named"));
  meta.robot = "/somewhere/arm.urdf";
  const auto result = parse(table.text(), meta);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->recording.q.cols(), 6);
}

TEST(AcceptedForms, CancelledIsNotFailed) {
  auto table = goodTable(Form::orientation, 2);
  std::string text = table.text();
  for (int k = 0; k < 70000; ++k) text += fmt::format("{},0,0,0,1,1,2,3,4,5,6\n", 1.0 + k);
  std::stop_source source;
  source.request_stop();
  const auto result = parseRecording(text, "rec.csv", {}, {source.get_token(), {}});
  ASSERT_FALSE(result);
  EXPECT_TRUE(result.error().cancelled);
}

}  // namespace
}  // namespace heft
