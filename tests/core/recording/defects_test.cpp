// Defects of rows, time, units and orientations: each is found where it stands, and said with a remedy.
#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Cells, TextInANumberIsAnErrorWithItsPlace) {
  auto table = goodTable(Form::joints);
  table.cell(4, "q2") = "abc";
  EXPECT_THAT(failureOf(table.text()),
              AllOf(StartsWith("rec.csv:6:3: "), HasSubstr("\"abc\" in column q2 is not a number")));
  for (const char* text : {"1.5x", "0x1F", "1 2", "1.5 N", "--1", "1e", "12:30:01", "infrared", "\"1.5x\""}) {
    table.cell(4, "q2") = text;
    EXPECT_THAT(failureOf(table.text()), StartsWith("rec.csv:6:3: ")) << text;
  }
}

TEST(Cells, DecimalCommasAreNamed) {
  auto table = goodTable(Form::joints);
  table.cell(0, "fz") = "9,81";
  EXPECT_THAT(failureOf(table.text(";")), AllOf(StartsWith("rec.csv:2:11: "), HasSubstr("decimal points")));
  for (auto& row : table.rows)
    for (auto& cell : row) cell = "1,5";
  EXPECT_THAT(failureOf(table.text(",")), HasSubstr("decimal"));
}

TEST(Cells, CleanRemediesForUnitsInCells) {
  auto table = goodTable(Form::joints);
  table.cell(0, "fz") = "9.81 N";
  EXPECT_THAT(failureOf(table.text()), HasSubstr("number alone"));
}

TEST(Cells, RowsOfWrongLength) {
  auto few = goodTable(Form::joints);
  few.rows[9].pop_back();
  EXPECT_THAT(failureOf(few.text()),
              AllOf(StartsWith("rec.csv:11: "), HasSubstr("13 cells but the header names 14 columns")));
  auto many = goodTable(Form::joints);
  many.rows[9].push_back("5");
  EXPECT_THAT(failureOf(many.text()),
              AllOf(StartsWith("rec.csv:11:15: "), HasSubstr("15 cells but the header names 14")));
}

TEST(Cells, LineCutOffAtTheEndIsLeftOut) {
  auto text = goodTable(Form::joints).text();
  text.resize(text.size() - 30);
  const auto result = parse(text);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->recording.rows(), 199);
  ASSERT_NE(findCode(result->findings, "line_cut_off"), nullptr);
  EXPECT_EQ(findCode(result->findings, "line_cut_off")->where.line, 201);
}

TEST(Cells, BlankLinesBetweenRowsKeepLineNumbersRight) {
  auto table = goodTable(Form::joints);
  table.cell(100, "q1") = "oops";
  auto text = table.text();
  text.insert(text.find('\n') + 1, "\n\r\n  \n");
  EXPECT_THAT(failureOf(text), StartsWith("rec.csv:105:2: "));
  auto good = goodTable(Form::joints).text();
  good.insert(good.find('\n') + 1, "\n");
  const auto result = parse(good);
  ASSERT_TRUE(result);
  EXPECT_NE(findCode(result->findings, "blank_lines"), nullptr);
  EXPECT_EQ(result->recording.rows(), 200);
}

TEST(Missing, FewRowsAreLeftOut) {
  for (const char* value : {"nan", "NaN", "-nan", "inf", "-Infinity", "", "  ", "\"\"", "NA", "null", "1e999"}) {
    auto table = goodTable(Form::joints);
    table.addColumn("label", "free");
    table.addColumn("note");
    for (std::size_t r = 0; r < 200; ++r) table.cell(r, "note") = std::to_string(r);
    table.cell(7, "fy") = value;
    table.cell(50, "q3") = value;
    table.cell(50, "q4") = value;
    const auto result = parse(table.text());
    ASSERT_TRUE(result) << value << ": " << result.error().message;
    const auto& recording = result->recording;
    EXPECT_EQ(recording.rows(), 198);
    EXPECT_EQ(recording.q.rows(), 198);
    EXPECT_EQ(recording.labels.size(), 198u);
    ASSERT_EQ(recording.extra[0].cells.size(), 198u);
    EXPECT_EQ(recording.extra[0].cells[7], "8");
    EXPECT_EQ(recording.extra[0].cells[197], "199");
    EXPECT_EQ(recording.time(7), table.number(8, "time"));
    EXPECT_TRUE(recording.wrench.allFinite());
    EXPECT_TRUE(recording.q.allFinite());
    const auto* finding = findCode(result->findings, "values_missing");
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->severity, Severity::warning);
    EXPECT_THAT(finding->text, HasSubstr("2 of 200 rows"));
    EXPECT_EQ(finding->where.line, 9);
    EXPECT_EQ(finding->where.column, 10);
  }
}

TEST(Missing, ManyRowsAreAnError) {
  auto table = goodTable(Form::joints);
  for (std::size_t r = 20; r < 31; ++r) table.cell(r, "tz") = "nan";
  EXPECT_THAT(failureOf(table.text()),
              AllOf(StartsWith("rec.csv:22:14: "), HasSubstr("11 of 200 rows"), HasSubstr("column tz")));
  table.cell(30, "tz") = "0.5";
  EXPECT_TRUE(parse(table.text())) << "exactly 5 %";
}

TEST(Missing, SparseRatesAreSetAsideInstead) {
  auto table = goodTable(Form::joints, 200, true);
  for (std::size_t r = 0; r < 200; r += 2) table.cell(r, "dq5") = "";
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->recording.rows(), 200);
  EXPECT_EQ(result->recording.dq.rows(), 0);
  ASSERT_NE(findCode(result->findings, "columns_set_aside"), nullptr);
  EXPECT_THAT(findCode(result->findings, "columns_set_aside")->text, HasSubstr("100 of 200 rows"));
}

TEST(Missing, SparseSecondMotionFormIsSetAside) {
  const auto both = [] {
    auto table = goodTable(Form::joints);
    const auto pose = goodTable(Form::pose);
    for (const std::string name : {"px", "py", "pz", "qx", "qy", "qz", "qw"}) {
      table.addColumn(name);
      for (std::size_t r = 0; r < 200; ++r) table.rows[r].back() = pose.rows[r][pose.column(name)];
    }
    return table;
  };
  EXPECT_EQ(allLines(parse(both().text())->findings), "");
  auto joints = both();
  for (std::size_t r = 0; r < 200; r += 3) joints.cell(r, "q2") = "";
  const auto posed = parse(joints.text());
  ASSERT_TRUE(posed) << posed.error().message;
  EXPECT_FALSE(posed->recording.hasJoints());
  EXPECT_EQ(posed->recording.position.rows(), 200);
  auto pose = both();
  for (std::size_t r = 0; r < 200; r += 3) pose.cell(r, "pz") = "";
  const auto jointed = parse(pose.text());
  ASSERT_TRUE(jointed) << jointed.error().message;
  EXPECT_FALSE(jointed->recording.hasOrientation());
  EXPECT_FALSE(jointed->recording.hasPosition());
  EXPECT_EQ(jointed->recording.q.rows(), 200);
}

TEST(Time, FallingIsAnErrorWithItsLine) {
  auto table = goodTable(Form::joints);
  table.cell(50, "time") = "0.1";
  EXPECT_THAT(failureOf(table.text()),
              AllOf(StartsWith("rec.csv:52:1: "), HasSubstr("time decreases from 0.49 s to 0.1 s")));
}

TEST(Time, RepeatedStampsAreLeftOut) {
  auto table = goodTable(Form::joints);
  table.cell(50, "time") = table.cell(49, "time");
  table.cell(51, "time") = table.cell(49, "time");
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->recording.rows(), 198);
  EXPECT_EQ(result->recording.q(49, 0), table.number(49, "q1")) << "the first of them stays";
  EXPECT_EQ(result->recording.q(50, 0), table.number(52, "q1"));
  const auto* finding = findCode(result->findings, "time_repeated");
  ASSERT_NE(finding, nullptr);
  EXPECT_THAT(finding->text, HasSubstr("2 of 200 rows (1 %)"));
  EXPECT_EQ(finding->where.line, 52);
}

TEST(Time, NeverRisingIsAnError) {
  auto table = goodTable(Form::joints);
  table.setColumn("time", "5");
  EXPECT_THAT(failureOf(table.text()), AllOf(StartsWith("rec.csv:3:1: "), HasSubstr("stays at 5 s")));
}

TEST(Time, GapsAreCountedAndTheLongestIsPlaced) {
  auto table = goodTable(Form::joints);
  for (std::size_t r = 60; r < 200; ++r)
    table.cell(r, "time") = fmt::format("{}", table.number(r, "time") + (r < 120 ? 0.1 : 0.6));
  const auto result = parse(table.text());
  ASSERT_TRUE(result);
  const auto* finding = findCode(result->findings, "time_gap");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->where.line, 122);
  EXPECT_THAT(finding->text, AllOf(HasSubstr("2 gaps"), HasSubstr("0.51 s"), HasSubstr("10 ms")));
  EXPECT_THAT(finding->remedy, HasSubstr("gaps of more than 20 ms are left out")) << "and not interpolated";
}

TEST(Time, JitterIsMeasured) {
  const auto jittered = [](double size) {
    auto table = goodTable(Form::joints);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-size, size);
    for (std::size_t r = 0; r < 200; ++r)
      table.cell(r, "time") = fmt::format("{}", 0.01 * static_cast<double>(r) + uniform(random));
    return parse(table.text());
  };
  EXPECT_EQ(findCode(jittered(0.0001)->findings, "time_jitter"), nullptr);
  const auto mild = jittered(0.002);
  ASSERT_NE(findCode(mild->findings, "time_jitter"), nullptr);
  EXPECT_EQ(findCode(mild->findings, "time_jitter")->severity, Severity::info);
  const auto wild = jittered(0.0049);
  ASSERT_NE(findCode(wild->findings, "time_irregular"), nullptr);
  EXPECT_EQ(findCode(wild->findings, "time_irregular")->severity, Severity::warning);
}

TEST(Time, OtherUnitsAreNotBelieved) {
  for (const double factor : {1e3, 1e6, 1e9}) {  // 10 ms steps in ms, us, ns
    auto table = goodTable(Form::joints);
    table.scaleColumn("time", factor);
    EXPECT_THAT(failureOf(table.text()), AllOf(HasSubstr("time"), HasSubstr("seconds"), HasSubstr("poses"))) << factor;
  }
  auto fast = goodTable(Form::joints, 200, true);
  fast.scaleColumn("time", 100.0);  // a step of 1, as of 1 kHz in ms; the velocities tell
  for (int j = 1; j <= 7; ++j) fast.scaleColumn(fmt::format("dq{}", j), 10.0);
  EXPECT_THAT(failureOf(fast.text()), HasSubstr("milliseconds"));
}

TEST(Time, SlowRecordingsAreSaid) {
  auto table = goodTable(Form::joints);
  table.scaleColumn("time", 100.0 / 30.0);
  const auto result = parse(table.text());
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_NE(findCode(result->findings, "rate_low"), nullptr);
  EXPECT_THAT(findCode(result->findings, "rate_low")->text, HasSubstr("30 Hz"));
}

TEST(Units, DegreesAreAnErrorNeverConverted) {
  auto table = goodTable(Form::joints);
  for (int j = 1; j <= 7; ++j) table.scaleColumn(fmt::format("q{}", j), 57.29577951308232);
  EXPECT_THAT(failureOf(table.text()), AllOf(StartsWith("rec.csv:"), HasSubstr("radians"), HasSubstr("angle_unit")));
}

TEST(Units, DegreesPerSecondAreFoundFromTheAngles) {
  auto table = goodTable(Form::joints, 200, true);
  for (int j = 1; j <= 7; ++j) table.scaleColumn(fmt::format("dq{}", j), 57.29577951308232);
  EXPECT_THAT(failureOf(table.text()), AllOf(HasSubstr("column 9"), HasSubstr("degrees per second")));
  auto small = goodTable(Form::joints, 200, true);
  for (int j = 1; j <= 7; ++j) small.scaleColumn(fmt::format("q{}", j), 5.729577951308232);
  for (int j = 1; j <= 7; ++j) small.scaleColumn(fmt::format("dq{}", j), 0.1);
  EXPECT_THAT(failureOf(small.text()), HasSubstr("the angles are in degrees"))
      << "small angles in degrees pass for radians";
  auto twist = goodTable(Form::pose, 200, true);
  for (const char* name : {"wx", "wy", "wz"}) twist.scaleColumn(name, 57.29577951308232);
  EXPECT_THAT(failureOf(twist.text()), HasSubstr("degrees per second"));
}

TEST(Units, ManyTurnsOfOtherArmsAreOnlySaid) {
  auto table = goodTable(Form::joints);
  table.scaleColumn("q6", 10.0);
  RecordingMeta meta;
  meta.robot = "/arm.urdf";
  const auto result = parse(table.text(), meta);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_NE(findCode(result->findings, "joint_angle_large"), nullptr);
  EXPECT_FALSE(parse(table.text()));
}

TEST(Units, MillimetresAreAnError) {
  auto table = goodTable(Form::pose);
  for (const char* name : {"px", "py", "pz"}) table.scaleColumn(name, 1000.0);
  EXPECT_THAT(failureOf(table.text()), AllOf(HasSubstr("metres"), HasSubstr("length_unit")));
  auto velocity = goodTable(Form::pose, 200, true);
  for (const char* name : {"vx", "vy", "vz"}) velocity.scaleColumn(name, 1000.0);
  EXPECT_THAT(failureOf(velocity.text()), HasSubstr("mm/s"));
}

TEST(Units, VelocitiesThatDoNotFitAreSaid) {
  auto swapped = goodTable(Form::joints, 200, true);
  std::swap(swapped.names[swapped.column("dq1")], swapped.names[swapped.column("dq4")]);
  std::swap(swapped.names[swapped.column("dq2")], swapped.names[swapped.column("dq6")]);
  const auto result = parse(swapped.text());
  ASSERT_TRUE(result);
  EXPECT_NE(findCode(result->findings, "velocity_disagrees"), nullptr);
}

TEST(Units, VelocitiesFitAcrossAGapAFrozenPostureAndALeap) {
  for (const Form form : {Form::joints, Form::pose}) {
    const Table good = goodTable(form, 400, true);
    const char* first = form == Form::joints ? "q1" : "px";
    Table gap = good, frozen = good, leap = good;
    gap.rows.erase(gap.rows.begin() + 100, gap.rows.begin() + 250);
    const auto from = static_cast<std::ptrdiff_t>(good.column(first)), to = from + 7;  // Joints, or the pose
    for (std::size_t r = 100; r < 250; ++r)
      std::copy(good.rows[99].begin() + from, good.rows[99].begin() + to, frozen.rows[r].begin() + from);
    for (std::size_t r = 200; r < 400; ++r) leap.cell(r, first) = fmt::format("{}", leap.number(r, first) + 2.0);
    for (const Table* table : std::initializer_list<const Table*>{&good, &gap, &frozen, &leap}) {
      const auto result = parse(table->text());
      ASSERT_TRUE(result) << result.error().message;
      const auto* finding = findCode(result->findings, "velocity_disagrees");
      EXPECT_EQ(finding, nullptr) << finding->text;
    }
    // What is wrong is still found there.
    frozen.scaleColumn(form == Form::joints ? "dq1" : "vx", -40.0);
    const auto result = parse(frozen.text());
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_NE(findCode(result->findings, "velocity_disagrees"), nullptr);
  }
}

TEST(Units, TorquesInNewtonMillimetresAreSaid) {
  auto table = goodTable(Form::joints);
  for (const char* name : {"tx", "ty", "tz"}) table.scaleColumn(name, 1000.0);
  const auto result = parse(table.text());
  ASSERT_TRUE(result);
  EXPECT_NE(findCode(result->findings, "torque_unit"), nullptr);
}

TEST(Quaternions, RoundedOnesAreNormalisedSilently) {
  auto table = goodTable(Form::orientation);
  for (std::size_t r = 0; r < 200; ++r)
    for (const char* name : {"qx", "qy", "qz", "qw"})
      table.cell(r, name) = fmt::format("{:.6f}", table.number(r, name));
  const auto result = parse(table.text());
  ASSERT_TRUE(result);
  EXPECT_EQ(allLines(result->findings), "");
  for (int k = 0; k < 200; ++k) EXPECT_NEAR(result->recording.quaternion.row(k).norm(), 1.0, 1e-15);
}

TEST(Quaternions, SlightlyOddOnesAreNormalisedAndSaid) {
  auto table = goodTable(Form::orientation);
  table.scaleColumn("qw", 1.0);
  for (const char* name : {"qx", "qy", "qz", "qw"})
    table.cell(20, name) = fmt::format("{}", 1.02 * table.number(20, name));
  const auto result = parse(table.text());
  ASSERT_TRUE(result);
  const auto* finding = findCode(result->findings, "quaternion_not_unit");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->where.line, 22);
  EXPECT_EQ(finding->severity, Severity::warning);
  EXPECT_NEAR(result->recording.quaternion.row(20).norm(), 1.0, 1e-15);
}

TEST(Quaternions, ZeroOrFarOffIsAnError) {
  auto zero = goodTable(Form::orientation);
  for (const char* name : {"qx", "qy", "qz", "qw"}) zero.cell(0, name) = "0";
  EXPECT_THAT(failureOf(zero.text()),
              AllOf(StartsWith("rec.csv:2:2: "), HasSubstr("length 0"), HasSubstr("no pose yet")));
  auto far = goodTable(Form::orientation);
  far.cell(5, "qw") = "2";
  EXPECT_THAT(failureOf(far.text()), AllOf(StartsWith("rec.csv:7:2: "), HasSubstr("length 2")));
  auto huge = goodTable(Form::orientation);
  huge.cell(5, "qw") = "1e300";
  EXPECT_THAT(failureOf(huge.text()), StartsWith("rec.csv:7:2: "));
}

TEST(Quaternions, SignFlipsAreMadeContinuous) {
  auto table = goodTable(Form::orientation);
  const auto expected = parse(table.text());
  for (std::size_t r = 40; r < 200; r += 1 + r % 3)
    for (const char* name : {"qx", "qy", "qz", "qw"}) table.cell(r, name) = fmt::format("{}", -table.number(r, name));
  const auto result = parse(table.text());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->recording.quaternion, expected->recording.quaternion);
}

}  // namespace
}  // namespace heft
