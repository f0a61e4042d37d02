// Channels that live, hang, repeat or jump.
#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;

Findings findingsOf(const Table& table, RecordingMeta meta = pandaMeta()) {
  const auto result = parse(table.text(), std::move(meta));
  EXPECT_TRUE(result) << result.error().message;
  return result ? result->findings : Findings{};
}

TEST(Frozen, WrenchChannelIsNamedWithItsColumn) {
  auto table = goodTable(Form::joints);
  table.setColumn("ty", "0.25");
  const auto findings = findingsOf(table);
  const auto* finding = findCode(findings, "channel_frozen");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->severity, Severity::warning);
  EXPECT_EQ(finding->where.column, 13);
  EXPECT_THAT(finding->text, AllOf(HasSubstr("ty"), HasSubstr("0.25")));
  EXPECT_EQ(findings.size(), 1u);
}

TEST(Frozen, MotionChannelsAreNamed) {
  auto joint = goodTable(Form::joints);
  joint.setColumn("q5", "1.5");
  ASSERT_NE(findCode(findingsOf(joint), "channel_frozen"), nullptr);
  auto rate = goodTable(Form::joints, 200, true);
  for (int j = 1; j <= 7; ++j) rate.setColumn(fmt::format("dq{}", j), "0");
  EXPECT_EQ(findCode(findingsOf(rate), "channel_frozen")->where.column, 9);
  auto position = goodTable(Form::pose);
  for (const char* name : {"px", "py", "pz"}) position.setColumn(name, "0.5");
  EXPECT_THAT(findCode(findingsOf(position), "channel_frozen")->text, HasSubstr("px, py, pz"));
}

TEST(Frozen, AxisOfATurnMayKeepItsComponent) {
  auto table = goodTable(Form::orientation);
  for (std::size_t r = 0; r < 200; ++r) {
    const double half = 0.01 * static_cast<double>(r);
    table.cell(r, "qx") = table.cell(r, "qy") = "0";
    table.cell(r, "qz") = fmt::format("{}", std::sin(half));
    table.cell(r, "qw") = fmt::format("{}", std::cos(half));
  }
  EXPECT_EQ(allLines(findingsOf(table)), "");
}

TEST(Frozen, WholeMotionOrEverything) {
  auto table = goodTable(Form::orientation);
  for (const char* name : {"qx", "qy", "qz"}) table.setColumn(name, "0");
  table.setColumn("qw", "1");
  EXPECT_NE(findCode(findingsOf(table), "motion_frozen"), nullptr);
  for (const char* name : {"fx", "fy", "fz", "tx", "ty", "tz"}) table.setColumn(name, "1");
  const auto findings = findingsOf(table);
  EXPECT_NE(findCode(findings, "nothing_changes"), nullptr);
  EXPECT_EQ(findings.size(), 1u);
}

TEST(Frozen, StretchesOfTheWrench) {
  auto table = goodTable(Form::joints, 600);
  for (std::size_t r = 300; r < 360; ++r)
    for (const char* name : {"fx", "fy", "fz", "tx", "ty", "tz"}) table.cell(r, name) = table.cell(299, name);
  const auto findings = findingsOf(table);
  const auto* finding = findCode(findings, "stretch_frozen");
  ASSERT_NE(finding, nullptr);
  EXPECT_THAT(finding->text,
              AllOf(HasSubstr("The wrench"), HasSubstr("2.99"), HasSubstr("3.59"), HasSubstr("61 rows")));
  EXPECT_EQ(finding->where.line, 301);
}

TEST(Frozen, StretchOfOneChannel) {
  auto table = goodTable(Form::joints, 600);
  for (std::size_t r = 300; r < 360; ++r) table.cell(r, "fz") = "32";
  const auto findings = findingsOf(table);
  const auto* finding = findCode(findings, "stretch_frozen");
  ASSERT_NE(finding, nullptr);
  EXPECT_THAT(finding->text, HasSubstr("fz"));
  EXPECT_EQ(finding->where.column, 11);
}

TEST(Frozen, ArmAtRestWithoutNoiseIsNoDefect) {
  auto table = goodTable(Form::joints, 600);
  for (std::size_t r = 301; r < 400; ++r)
    for (std::size_t c = 1; c < table.names.size(); ++c) table.rows[r][c] = table.rows[300][c];
  for (std::size_t r = 400; r < 600; ++r)  // starts again gently
    for (std::size_t c = 1; c < table.names.size(); ++c) table.rows[r][c] = table.rows[r - 99][c];
  EXPECT_EQ(findCode(findingsOf(table), "stretch_frozen"), nullptr);
}

TEST(Frozen, LoggerThatHungIsSeenFromTheJump) {
  auto table = goodTable(Form::joints, 600);
  for (std::size_t r = 300; r < 340; ++r)
    for (int j = 1; j <= 7; ++j) table.cell(r, fmt::format("q{}", j)) = table.cell(299, fmt::format("q{}", j));
  const auto findings = findingsOf(table);
  const auto* finding = findCode(findings, "stretch_frozen");
  ASSERT_NE(finding, nullptr) << allLines(findings);
  EXPECT_THAT(finding->text, HasSubstr("The posture"));
}

TEST(Tare, ASpikeIsNoLoad) {
  auto table = goodTable(Form::joints, 600);
  table.cell(400, "fx") = "100000";
  EXPECT_EQ(findCode(findingsOf(table), "wrench_tared"), nullptr);
}

TEST(Repeats, CoarseStepsAreNoRate) {
  auto table = goodTable(Form::joints, 400);
  for (std::size_t r = 0; r < 400; ++r)
    for (const char* name : {"fx", "fy", "fz", "tx", "ty", "tz"})
      table.cell(r, name) = std::to_string(r / 7 % 3 == 2 ? 1 : r / 7 % 3);
  const auto findings = findingsOf(table);
  EXPECT_EQ(findCode(findings, "wrench_repeated"), nullptr);
  EXPECT_NE(findCode(findings, "coarse_steps"), nullptr) << allLines(findings);
}

TEST(Repeats, ShareAndTrueRateAreSaid) {
  auto table = goodTable(Form::joints, 400);
  for (std::size_t r = 1; r < 400; r += 2)
    for (const char* name : {"fx", "fy", "fz", "tx", "ty", "tz"}) table.cell(r, name) = table.cell(r - 1, name);
  const auto findings = findingsOf(table);
  const auto* finding = findCode(findings, "wrench_repeated");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->severity, Severity::warning);
  EXPECT_EQ(finding->where.line, 3);
  EXPECT_THAT(finding->text, AllOf(HasSubstr("50 %"), HasSubstr("49.9 Hz"), HasSubstr("100 Hz")));
}

TEST(Repeats, FewAreInformationOnly) {
  auto table = goodTable(Form::joints, 400);
  for (std::size_t r = 10; r < 400; r += 20)
    for (const char* name : {"fx", "fy", "fz", "tx", "ty", "tz"}) table.cell(r, name) = table.cell(r - 1, name);
  const auto findings = findingsOf(table);
  ASSERT_NE(findCode(findings, "wrench_repeated"), nullptr);
  EXPECT_EQ(findCode(findings, "wrench_repeated")->severity, Severity::info);
}

TEST(Repeats, PostureToo) {
  auto table = goodTable(Form::pose, 400);
  for (std::size_t r = 0; r < 400; ++r)
    for (const char* name : {"px", "py", "pz", "qx", "qy", "qz", "qw"})
      table.cell(r, name) = table.cell(r - r % 4, name);
  const auto findings = findingsOf(table);
  ASSERT_NE(findCode(findings, "posture_repeated"), nullptr);
  EXPECT_EQ(findCode(findings, "posture_repeated")->severity, Severity::warning);
}

TEST(Jumps, AreSaidWithTheirLine) {
  auto table = goodTable(Form::joints);
  for (std::size_t r = 80; r < 200; ++r) table.cell(r, "q7") = fmt::format("{}", table.number(r, "q7") + 0.8);
  const auto findings = findingsOf(table);
  const auto* finding = findCode(findings, "motion_jump");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->where.line, 82);
  EXPECT_EQ(finding->where.column, 8);
}

TEST(Tare, ZeroStartIsMentioned) {
  auto table = goodTable(Form::joints, 400);
  for (const char* name : {"fx", "fy", "fz"}) {
    double start = 0.0;
    for (std::size_t r = 0; r < 5; ++r) start += table.number(r, name) / 5.0;
    for (std::size_t r = 0; r < 400; ++r)
      table.cell(r, name) = fmt::format("{}", 5.0 * (table.number(r, name) - start));
  }
  const auto findings = findingsOf(table);
  ASSERT_NE(findCode(findings, "wrench_tared"), nullptr) << allLines(findings);
  EXPECT_EQ(findCode(findings, "wrench_tared")->severity, Severity::info);
}

TEST(Marks, OutsideTheRecordingAreSaid) {
  auto meta = pandaMeta();
  meta.marks = {{0.5, 1.0, MarkLabel::free}, {100.0, 101.0, MarkLabel::contact}};
  const auto findings = findingsOf(goodTable(Form::joints), meta);
  ASSERT_EQ(findings.size(), 1u) << allLines(findings);
  EXPECT_EQ(findings[0].code, "mark_outside");
}

}  // namespace
}  // namespace heft
