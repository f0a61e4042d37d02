// Names, units, times and layouts of tables and arrays as other programs write them: each small input says what is
// right.
#include <fmt/format.h>

#include <limits>
#include <utility>
#include <vector>

#include "core/import/date_time.h"
#include "core/import/field_name.h"
#include "core/import/time_column.h"
#include "core/robot/robot_model.h"
#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Spellings = InFolder;

/// A table of the fixtures' formula, 100 rows at 100 Hz: `header`, then the time as `time` writes it, the joints times
/// `jointScale` and the wrench times `wrenchScale`.
template <class Time>
std::string table(const std::string& header, Time time, double jointScale = 1.0, double wrenchScale = 1.0,
                  char separator = ',') {
  std::string out = header + "\n";
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    out += time(k);
    for (int j = 0; j < 7; ++j) out += fmt::format("{}{:.9g}", separator, jointScale * jointAt(t, j));
    for (int a = 0; a < 6; ++a) out += fmt::format("{}{:.9g}", separator, wrenchScale * wrenchAt(t, a));
    out += "\n";
  }
  return out;
}

std::string plainTime(int k) { return fmt::format("{:.2f}", 0.01 * k); }

/// "PREFIX1SUFFIX,...": seven joints and six wrench names.
std::string header(const std::string& time, const std::string& joint, const std::vector<std::string>& wrench,
                   int first = 1, char separator = ',') {
  std::string out = time;
  for (int j = first; j < first + 7; ++j) out += separator + fmt::format(fmt::runtime(joint), j);
  for (const auto& name : wrench) out += separator + name;
  return out;
}

std::vector<std::string> six(const std::string& name, int first) {
  std::vector<std::string> out;
  for (int i = first; i < first + 6; ++i) out.push_back(fmt::format(fmt::runtime(name), i));
  return out;
}

TEST(FieldNames, WordsAndUnits) {
  EXPECT_EQ(wordsOf("position[panda_joint1]"), (Words{"position", "panda", "joint", "1"}));
  EXPECT_EQ(wordsOf("TCPForceX"), (Words{"tcp", "force", "x"}));
  EXPECT_EQ(readFieldName("Fx (N)").unit, "n");
  EXPECT_EQ(readFieldName("q1_deg").unit, "deg");
  EXPECT_EQ(readFieldName("dq1_rad_s").unit, "rad/s");
  EXPECT_EQ(readFieldName("Torque X [N mm]").unit, "nmm");
  EXPECT_EQ(readFieldName("Fx / N").unit, "n");
  EXPECT_EQ(readFieldName("wrench[3]").unit, "");
  EXPECT_EQ(readFieldName("position[m]").unit, "");
  EXPECT_EQ(readFieldName("/ft/force/x").unit, "");
  EXPECT_EQ(readFieldName("header.stamp.nanosec").words, (Words{"header", "stamp"}));
  EXPECT_NEAR(*unitSi("deg", Quantity::angle), kDegree, 1e-15);
  EXPECT_NEAR(*unitSi("lbf", Quantity::force), 4.4482216, 1e-6);
  EXPECT_FALSE(unitSi("n", Quantity::torque));
}

TEST(Dates, AreSecondsSince1970) {
  EXPECT_DOUBLE_EQ(*secondsOfDate("1970-01-02 00:00:01.5"), 86401.5);
  EXPECT_DOUBLE_EQ(*secondsOfDate("1970-01-01T01:00:00+01:00"), 0.0);
  EXPECT_DOUBLE_EQ(*secondsOfDate("02.01.1970 00:00:00,25"), 86400.25);
  EXPECT_DOUBLE_EQ(*secondsOfDate("1/2/1970 1:00:00 PM"), 86400.0 + 46800.0);
  EXPECT_DOUBLE_EQ(*secondsOfDate("13/1/1970 00:00:00"), 12 * 86400.0);
  EXPECT_DOUBLE_EQ(*secondsOfDate("00:01:00.125"), 60.125);
  for (const char* const other : {"12.5", "1700000000", "panda", "2024-13-01", "25:00", "", "1-2", "-3.4e-5"})
    EXPECT_FALSE(secondsOfDate(other)) << other;
}

TEST_F(Spellings, JointsAndWrenchesUnderManyNames) {
  const std::vector<std::string> plain = {"fx", "fy", "fz", "tx", "ty", "tz"};
  const std::vector<std::pair<std::string, std::string>> tables = {
      {"units", header("Time (s)", "J{} (rad)", {"Fx (N)", "Fy (N)", "Fz (N)", "Mx (Nm)", "My (Nm)", "Mz (Nm)"})},
      {"prefixes", header("time", "robot.q{}", {"ft.Fx", "ft.Fy", "ft.Fz", "ft.Mx", "ft.My", "ft.Mz"})},
      {"timestamp", header("timestamp", "q{}", plain)},
      {"rtde", header("timestamp", "actual_q_{}", six("ft_raw_wrench_{}", 0), 0)},
      {"readings", header("Timestamp", "joint_angles_{}", six("fts_reading_{}", 1))},
      {"arrays", header("t", "q[{}]", six("wrench[{}]", 0), 0)},
      {"dotted",
       header("time", "position.{}", {"force.0", "force.1", "force.2", "torque.0", "torque.1", "torque.2"}, 0)},
      {"camel", header("time", "jointPosition{}", {"forceX", "forceY", "forceZ", "torqueX", "torqueY", "torqueZ"})},
      {"quoted",
       header("time", "q{}",
              {"\"Force, X\"", "\"Force, Y\"", "\"Force, Z\"", "\"Torque, X\"", "\"Torque, Y\"", "\"Torque, Z\""})},
      {"kuka", header("time", "A{}", plain)},
      {"sensor", header("time", "joint_{}", {"Fx_raw", "Fy_raw", "Fz_raw", "Tx_raw", "Ty_raw", "Tz_raw"})},
  };
  for (const auto& [name, head] : tables) {
    const auto read = openRecording(write(name + ".csv", table(head, plainTime)));
    ASSERT_TRUE(read.ok()) << name << ": " << read.error().message;
    expectFormula(read->recording);
  }
}

TEST_F(Spellings, TheUnitInANameIsBelieved) {
  const auto names = {"fx (kgf)", "fy (kgf)", "fz (kgf)", "tx (kgf m)", "ty (kgf m)", "tz (kgf m)"};
  const auto text = table(
      header("time_ms", "q{}_deg", {names.begin(), names.end()}), [](int k) { return std::to_string(10 * k); },
      1.0 / kDegree, 1.0 / 9.80665);
  const auto read = openRecording(write("named.csv", text));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_TRUE(hasCode(read->findings, "units_named"));
  expectFormula(read->recording);
  // Said by the user or found, the name is the same.
  ImportOptions options;
  options.use = {"time=time_ms"};
  const auto said = openRecording(folder_ / "named.csv", options);
  ASSERT_TRUE(said.ok()) << said.error().message;
  expectFormula(said->recording);
  // A unit that is stated besides does not count twice.
  write("named.meta.json", R"({"robot": "panda", "angle_unit": "deg", "sensor": {"force_unit": "kgf"}})");
  const auto stated = openRecording(folder_ / "named.csv");
  ASSERT_TRUE(stated.ok()) << stated.error().message;
  expectFormula(stated->recording);
}

TEST_F(Spellings, TimesInTwoColumnsAsDatesAndWithoutAClock) {
  const std::vector<std::string> plain = {"fx", "fy", "fz", "tx", "ty", "tz"};
  const auto split = [](int k) { return fmt::format("{},{}", 1700000000 + k / 100, 10000000 * (k % 100)); };
  for (const char* const names : {"secs,nsecs", "header.stamp.sec,header.stamp.nanosec", "stamp_sec,stamp_nsec"}) {
    const auto read = openRecording(write("split.csv", table(header(names, "q{}", plain), split)));
    ASSERT_TRUE(read.ok()) << names << ": " << read.error().message;
    expectFormula(read->recording);
  }
  ImportOptions options;
  options.use = {"time=secs"};
  const auto chosen = openRecording(write("split.csv", table(header("secs,nsecs", "q{}", plain), split)), options);
  ASSERT_TRUE(chosen.ok()) << chosen.error().message;
  expectFormula(chosen->recording);

  const std::vector<std::string> dates = {"2024-01-05 12:00:00.{:02}", "2024-01-05T12:00:00.{:02}Z",
                                          "05.01.2024 12:00:00.{:02}", "12:00:00.{:02}"};
  for (const auto& form : dates) {
    const auto read = openRecording(write(
        "dates.csv", table(header("time", "q{}", plain), [&](int k) { return fmt::format(fmt::runtime(form), k); })));
    ASSERT_TRUE(read.ok()) << form << ": " << read.error().message;
    const double first = form.size() < 20 ? 43200.0 : 0.0;  // a time of the day counts from midnight
    expectFormula(read->recording, -first);
  }

  const auto clockless = write("clockless.csv", table(header("sample", "q{}", plain), [](int) { return "7"; }));
  const auto without = openRecording(clockless);
  ASSERT_FALSE(without.ok());
  options.use.clear();
  options.rateHz = 100.0;
  const auto rated = openRecording(clockless, options);
  ASSERT_TRUE(rated.ok()) << rated.error().message;
  expectFormula(rated->recording);
}

TEST_F(Spellings, PreamblesUnitRowsSeparatorsAndCommas) {
  const std::vector<std::string> plain = {"fx", "fy", "fz", "tx", "ty", "tz"};
  const auto body = table(header("time", "q{}", plain), plainTime);
  std::string units = "s";
  for (int i = 0; i < 13; ++i) units += i < 7 ? ",rad" : i < 10 ? ",N" : ",N m";
  const auto line = body.find('\n') + 1;
  std::string semicolons = body, blanks = body, hash = "# " + body, tabs = body;
  for (char& c : semicolons) c = c == ',' ? ';' : c == '.' ? ',' : c;
  for (char& c : blanks) c = c == ',' ? ' ' : c;
  for (char& c : tabs) c = c == ',' ? '\t' : c;
  std::string utf16 = "\xFF\xFE";
  for (const char c : body) utf16 += std::string{c, '\0'};
  const std::vector<std::pair<std::string, std::string>> files = {
      {"preamble.csv", "Device,Net F/T\nSerial number,FT12345\nSampling rate,100,Hz\n\n" + body},
      {"units.csv", body.substr(0, line) + units + "\n" + body.substr(line)},
      {"german.csv", semicolons},
      {"blanks.txt", blanks},
      {"tabs.txt", tabs},
      {"hash.csv", hash},
      {"utf16.csv", utf16}};
  for (const auto& [name, text] : files) {
    const auto read = openRecording(write(name, text));
    ASSERT_TRUE(read.ok()) << name << ": " << read.error().message;
    expectFormula(read->recording);
  }
  const auto nameless = openRecording(write("nameless.csv", body.substr(line)));
  ASSERT_FALSE(nameless.ok());
  EXPECT_THAT(nameless.error().message, HasSubstr("looks like data"));
  ImportOptions options;
  options.use = {"time=column1"};
  for (int j = 1; j <= 7; ++j) options.use.push_back(fmt::format("q{}=column{}", j, j + 1));
  for (int a = 0; a < 6; ++a)
    options.use.push_back(fmt::format("{}=column{}", plain[static_cast<std::size_t>(a)], a + 9));
  const auto numbered = openRecording(folder_ / "nameless.csv", options);
  ASSERT_TRUE(numbered.ok()) << numbered.error().message;
  expectFormula(numbered->recording);
}

TEST_F(Spellings, RawComesBeforeWhatWasMadeOfIt) {
  const std::vector<std::string> kinds = {"filtered_", "averaged_", "", "thresholded_", "world_", "target_"};
  std::string head = "time";
  for (int j = 1; j <= 7; ++j) head += fmt::format(",target_q{}", j);
  for (int j = 1; j <= 7; ++j) head += fmt::format(",q{}_estimated", j);
  for (int j = 1; j <= 7; ++j) head += fmt::format(",actual_q{}", j);
  for (const auto& kind : kinds)
    for (const char* const name : {"fx", "fy", "fz", "tx", "ty", "tz"}) head += "," + kind + name;
  std::string text = head + "\n";
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    text += fmt::format("{:.2f}", t);
    for (const double off : {0.3, 0.2, 0.0})
      for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9g}", jointAt(t, j) + off);
    for (const auto& kind : kinds)
      for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9g}", wrenchAt(t, a) + (kind.empty() ? 0.0 : 1.0));
    text += "\n";
  }
  const auto read = openRecording(write("several.csv", text));
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
}

TEST_F(Spellings, BetweenTwoWrenchesTheMotionDecides) {
  // A tool of 1 kg at the wrist of a Panda: the rear sensor carries it, the front one shakes by itself.
  std::string text = "time,q1,q2,q3,q4,q5,q6,q7";
  for (const char* const kind : {"front", "rear"})
    for (const char* const name : {"fx", "fy", "fz", "tx", "ty", "tz"}) text += fmt::format(",{}_{}", kind, name);
  text += "\n";
  const auto& panda = RobotModel::panda();
  const auto link = *panda.findLink("panda_link8");
  VectorXd q(7);
  for (int k = 0; k < 1200; ++k) {
    const double t = 0.01 * k;
    q << 0.0, -0.785, 0.0, -2.356, std::sin(0.9 * t), 1.571 + 0.7 * std::sin(1.3 * t), 0.785 + std::sin(0.7 * t);
    const Vector3d weight = panda.linkPose(q, link).linear().transpose() * Vector3d(0.0, 0.0, 9.81);
    text += fmt::format("{:.2f}", t);
    for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9g}", q(j));
    for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9g}", std::sin(17.0 * t + a));
    for (int a = 0; a < 3; ++a) text += fmt::format(",{:.9g}", weight(a));
    text += ",0.1,0.2,0.3\n";
  }
  const auto read = openRecording(write("two.csv", text));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->findings.front().code, "wrench_of_several");
  EXPECT_NEAR(read->recording.wrench.row(600).head<3>().norm(), 9.81, 1e-6);
}

TEST_F(Spellings, PosesAsRotationVectorsAnglesAndMatrices) {
  // A turn of 0.5 rad about x, then -0.3 about the new y would be no rotation vector that is easy to read: one axis.
  const std::string wrench = ",1,2,3,0.1,0.2,0.3\n";
  std::string vector =
      "time,actual_TCP_pose_0,actual_TCP_pose_1,actual_TCP_pose_2,actual_TCP_pose_3,actual_TCP_pose_4,"
      "actual_TCP_pose_5,fx,fy,fz,tx,ty,tz\n";
  std::string kuka = "time,X,Y,Z,A,B,C,fx,fy,fz,tx,ty,tz\n";
  std::string matrix = "time,r11,r12,r13,r21,r22,r23,r31,r32,r33,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 40; ++k) {
    const double angle = 0.02 * k, c = std::cos(angle), s = std::sin(angle);
    vector += fmt::format("{:.2f},0.4,0.1,0.5,{:.9g},0,0", 0.01 * k, angle) + wrench;
    kuka += fmt::format("{:.2f},400,100,500,0,0,{:.9g}", 0.01 * k, angle / kDegree) + wrench;
    matrix += fmt::format("{:.2f},1,0,0,0,{:.9g},{:.9g},0,{:.9g},{:.9g}", 0.01 * k, c, -s, s, c) + wrench;
  }
  for (const auto& [name, text] : {std::pair{"vector.csv", vector}, {"kuka.csv", kuka}, {"matrix.csv", matrix}}) {
    const auto read = openRecording(write(name, text));
    ASSERT_TRUE(read.ok()) << name << ": " << read.error().message;
    const auto& recording = read->recording;
    for (Eigen::Index k = 0; k < recording.rows(); ++k) {
      const double angle = 2.0 * recording.time(k);
      EXPECT_NEAR(recording.quaternion(k, 0), std::sin(0.5 * angle), 1e-8) << name;
      EXPECT_NEAR(recording.quaternion(k, 3), std::cos(0.5 * angle), 1e-8) << name;
    }
    if (recording.hasPosition()) {
      EXPECT_NEAR(recording.position(5, 0), 0.4, 1e-12) << name;
    }
  }
}

TEST_F(Spellings, TcpForceOfAUrIsInBaseAxes) {
  const auto read = openRecording(
      write("tcp.csv", table(header("timestamp", "actual_q_{}", six("actual_TCP_force_{}", 0), 0), plainTime)));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_TRUE(hasCode(read->findings, "base_axes_known"));
  EXPECT_TRUE(read->recording.wrenchNeedsPose);
  // Where the user says otherwise, that holds.
  write("tcp.meta.json", R"({"robot": "panda", "sensor": {"wrench_axes": "sensor"}})");
  const auto stated = openRecording(folder_ / "tcp.csv");
  ASSERT_TRUE(stated.ok()) << stated.error().message;
  EXPECT_FALSE(stated->recording.wrenchNeedsPose);
}

TEST_F(Spellings, AClockThatStartsAgainIsRefused) {
  const std::vector<std::string> plain = {"fx", "fy", "fz", "tx", "ty", "tz"};
  const auto read = openRecording(write("restart.csv", table(header("clock", "q{}", plain), [](int k) {
                                          return fmt::format("{:.3f}", k < 60 ? 5.0 + 0.02 * k : 5.5 + 0.02 * (k - 60));
                                        })));
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message, HasSubstr("two recordings"));
}

TEST_F(Spellings, ArraysOfNumPyAndMatlab) {
  for (const char* const name : {"log.npz", "table.npy", "log.mat"}) {
    const auto read = openRecording(fixture(name));
    ASSERT_TRUE(read.ok()) << name << ": " << read.error().message;
    EXPECT_EQ(read->recording.rows(), 101) << name;
    expectFormula(read->recording);
  }
  const auto parquet = openRecording(write("log.parquet", "PAR1 and so on"));
  ASSERT_FALSE(parquet.ok());
  EXPECT_THAT(parquet.error().message, HasSubstr("read_parquet"));
}

TEST_F(Spellings, OffsetsBeyondAnyClockAndOfUnknownNamesAreRefused) {
  write("far.map.json", R"({"offset_s": {"far.csv": 9e9}})");
  const std::vector<std::string> plain = {"fx", "fy", "fz", "tx", "ty", "tz"};
  const auto far = openRecording(write("far.csv", table(header("time", "q{}", plain), plainTime)));
  ASSERT_FALSE(far.ok());
  EXPECT_THAT(far.error().message, HasSubstr("63 years"));
  write("far.map.json", R"({"offset_s": {"/nothing": 1.0}})");
  const auto unknown = openRecording(folder_ / "far.csv");
  ASSERT_FALSE(unknown.ok());
  EXPECT_THAT(unknown.error().message, HasSubstr("/nothing"));
}

TEST(Stamps, BeyondTheirBoundAreNone) {
  EXPECT_EQ(nanoseconds(1.7e9), 1700000000000000000);
  EXPECT_EQ(nanoseconds(3e9), 0);
  EXPECT_EQ(nanoseconds(-3e9), 0);
  EXPECT_EQ(nanoseconds(std::nan("")), 0);
  EXPECT_EQ(soundStamp(kLargestStamp), 0);
  EXPECT_EQ(soundStamp(kLargestStamp - 1), kLargestStamp - 1);
  EXPECT_EQ(soundStamp(std::numeric_limits<std::int64_t>::min()), 0);
}

/// Words that are one in one language and two in another, and what was planned before what was measured.
TEST_F(Spellings, CompoundsAndPlansAreTold) {
  const std::vector<std::string> german = {"Kraft X [N]",   "Kraft Y [N]",   "Kraft Z [N]",
                                           "Moment X [Nm]", "Moment Y [Nm]", "Moment Z [Nm]"};
  const auto milliseconds = [](int k) { return fmt::format("{}", 10 * k); };
  for (const auto& names :
       {header("Zeitstempel [ms]", "Gelenkwinkel {} [rad]", german),
        header("ts_ms", "jointpos_{}", {"F[0]", "F[1]", "F[2]", "M[0]", "M[1]", "M[2]"}),
        header("clock_ms", "RobAx.rax_{}", {"LoadFx", "LoadFy", "LoadFz", "LoadTx", "LoadTy", "LoadTz"}),
        header("time_ms", "qMeas_{}", {"F_meas_1", "F_meas_2", "F_meas_3", "F_meas_4", "F_meas_5", "F_meas_6"}),
        header("tm_ms", "feedBack.joints[{}]",
               {"measuredForce.0", "measuredForce.1", "measuredForce.2", "measuredForce.3", "measuredForce.4",
                "measuredForce.5"},
               0)}) {
    const auto read = openRecording(write("words.csv", table(names, milliseconds)));
    ASSERT_TRUE(read.ok()) << names << ": " << read.error().message;
    expectFormula(read->recording);
  }
  const auto timetable =
      openRecording(write("timetable.csv", table(header("Time", "q{}", {"fx", "fy", "fz", "tx", "ty", "tz"}),
                                                 [](int k) { return fmt::format("{:.2f} sec", 0.01 * k); })));
  ASSERT_TRUE(timetable.ok()) << timetable.error().message;
  expectFormula(timetable->recording);
  std::string both = "t";
  for (int j = 0; j < 7; ++j) both += fmt::format(",planned.joints[{}]", j);
  for (int j = 0; j < 7; ++j) both += fmt::format(",now.joints[{}]", j);
  both += ",fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 100; ++k) {
    both += plainTime(k);
    for (int j = 0; j < 7; ++j) both += fmt::format(",{:.9g}", jointAt(0.01 * k, j) + 0.03);
    for (int j = 0; j < 7; ++j) both += fmt::format(",{:.9g}", jointAt(0.01 * k, j));
    for (int a = 0; a < 6; ++a) both += fmt::format(",{:.9g}", wrenchAt(0.01 * k, a));
    both += "\n";
  }
  const auto read = openRecording(write("planned.csv", both));
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
}

/// A pose that turns about z by 0.5 t and then about its x by 0.3, at 0.1, 0.2, 0.3 + t metres.
class PosesOfOthers : public InFolder {
 protected:
  static constexpr double kTilt = 0.3;
  template <class Row>
  Result<ReadRecording> opened(const std::string& names, Row row) {
    std::string text = names + ",fx,fy,fz,tx,ty,tz\n";
    for (int k = 0; k < 100; ++k) {
      const double t = 0.01 * k;
      text += fmt::format("{:.2f}", t) + row(t, Matrix3d(rotationFromRpy({kTilt, 0.0, 0.5 * t})));
      for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9g}", wrenchAt(t, a));
      text += "\n";
    }
    return openRecording(write("pose.csv", text));
  }
  void expectThePose(const Result<ReadRecording>& read) {
    ASSERT_TRUE(read.ok()) << read.error().message;
    const auto& recording = read->recording;
    ASSERT_TRUE(recording.hasOrientation() && recording.hasPosition());
    for (Eigen::Index k = 0; k < recording.rows(); ++k) {
      const Eigen::Vector4d q = recording.quaternion.row(k).transpose();
      const Matrix3d R = rotationFromRpy({kTilt, 0.0, 0.5 * recording.time(k)});
      EXPECT_NEAR((Quaterniond(q(3), q(0), q(1), q(2)).toRotationMatrix() - R).norm(), 0.0, 1e-6) << k;
      EXPECT_NEAR(recording.position(k, 2), 0.3 + recording.time(k), 1e-9) << k;
    }
  }
};

TEST_F(PosesOfOthers, AFanucsWpr) {
  expectThePose(opened("TIME,X,Y,Z,W,P,R", [](double t, const Matrix3d&) {
    return fmt::format(",100,200,{:.9g},{:.9g},0,{:.9g}", 300.0 + 1e3 * t, kTilt / kDegree, 0.5 * t / kDegree);
  }));
}

TEST_F(PosesOfOthers, LibfrankasMatrixByColumns) {
  std::string names = "t";
  for (int i = 0; i < 16; ++i) names += fmt::format(",O_T_EE[{}]", i);
  expectThePose(opened(names, [](double t, const Matrix3d& R) {
    std::string out;
    for (int c = 0; c < 3; ++c) out += fmt::format(",{:.9g},{:.9g},{:.9g},0", R(0, c), R(1, c), R(2, c));
    return out + fmt::format(",0.1,0.2,{:.9g},1", 0.3 + t);
  }));
}

TEST_F(PosesOfOthers, AMatrixByRowsCountedFromEither) {
  for (const int first : {0, 1}) {
    std::string names = "t";
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) names += fmt::format(",T_{}{}", r + first, c + first);
    expectThePose(opened(names, [](double t, const Matrix3d& R) {
      const Vector3d place(0.1, 0.2, 0.3 + t);
      std::string out;
      for (int r = 0; r < 3; ++r)
        out += fmt::format(",{:.9g},{:.9g},{:.9g},{:.9g}", R(r, 0), R(r, 1), R(r, 2), place(r));
      return out + ",0,0,0,1";
    }));
  }
}

TEST_F(PosesOfOthers, ARotationVectorWithWordsBeforeIt) {
  expectThePose(
      opened("t,TCP_X_mm,TCP_Y_mm,TCP_Z_mm,TCP_RX_rad,TCP_RY_rad,TCP_RZ_rad", [](double t, const Matrix3d& R) {
        const Eigen::AngleAxisd turn(R);
        const Vector3d v = turn.angle() * turn.axis();
        return fmt::format(",100,200,{:.9g},{:.9g},{:.9g},{:.9g}", 300.0 + 1e3 * t, v.x(), v.y(), v.z());
      }));
}

/// One JSON value that holds a whole table; what is no table keeps its own sentence.
TEST_F(Spellings, AJsonDocumentIsATable) {
  std::string times, joints, wrenches, objects;
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    std::string q, w;
    for (int j = 0; j < 7; ++j) q += fmt::format("{}{:.9g}", j > 0 ? "," : "", jointAt(t, j));
    for (int a = 0; a < 6; ++a) w += fmt::format("{}{:.9g}", a > 0 ? "," : "", wrenchAt(t, a));
    const char* const comma = k > 0 ? ",\n" : "";
    times += fmt::format("{}{:.2f}", comma, t);
    joints += fmt::format("{}[{}]", comma, q);
    wrenches += fmt::format("{}[{}]", comma, w);
    objects += fmt::format("{}{{\"time\":{:.2f},\"q\":[{}],\"wrench\":[{}]}}", comma, t, q, w);
  }
  for (const auto& text :
       {fmt::format(R"({{"who": "me", "limits": [1, 2], "time": [{}], "arm": {{"q": [{}]}}, "wrench": [{}]}})", times,
                    joints, wrenches),
        fmt::format("{{\n \"time\":\n [{}],\n\"q\": [{}], \"wrench\": [{}]\n}}\n", times, joints, wrenches),
        fmt::format("[{}]", objects), fmt::format("[\n{}\n]\n", objects)}) {
    const auto read = openRecording(write("whole.json", text));
    ASSERT_TRUE(read.ok()) << text.substr(0, 60) << ": " << read.error().message;
    expectFormula(read->recording);
    EXPECT_EQ(read->recording.rows(), 100);
  }
  const auto payload = openRecording(write("payload.json", "{\n \"mass_kg\": 1,\n \"com_m\": [0, 0, 0.1]\n}\n"));
  ASSERT_FALSE(payload.ok());
  EXPECT_THAT(payload.error().message, HasSubstr("this is JSON, not CSV"));
}

/// The rate that is stated is that of the file without a clock.
TEST_F(Spellings, ARateIsForTheFileWithoutAClock) {
  std::string joints = "time,q1,q2,q3,q4,q5,q6,q7\n", wrench = "fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 1000; ++k) {
    if (k % 2 == 0) {
      joints += fmt::format("{:.2f}", 0.01 * k);
      for (int j = 0; j < 7; ++j) joints += fmt::format(",{:.9g}", jointAt(0.01 * k, j));
      joints += "\n";
    }
    for (int a = 0; a < 6; ++a) wrench += fmt::format("{}{:.9g}", a > 0 ? "," : "", wrenchAt(0.01 * k, a));
    wrench += "\n";
  }
  ImportOptions options;
  options.join = {write("wrench.csv", wrench)};
  options.rateHz = 100.0;
  MappingWishes wishes;
  wishes.offset["wrench.csv"] = 0.0;
  options.wishes = wishes;
  const auto read = openRecording(write("joints.csv", joints), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_NEAR(read->recording.rateHz(), 50.0, 1e-6);
  EXPECT_NEAR(read->recording.duration(), 9.98, 0.05);
}

/// Where a part is missing, of the others what would be taken is proposed: no pose beside joints.
TEST_F(Spellings, NoPoseIsProposedBesideJoints) {
  std::string text = "timestamp";
  for (int j = 0; j < 6; ++j) text += fmt::format(",actual_q_{}", j);
  for (int j = 0; j < 6; ++j) text += fmt::format(",actual_TCP_pose_{}", j);
  text += "\n";
  for (int k = 0; k < 20; ++k) text += fmt::format("{:.2f},0,1,2,3,4,{},0.1,0.2,0.3,1,0,{}\n", 0.01 * k, k, 0.1 * k);
  const auto contents = inspectRecording(write("robot.csv", text));
  ASSERT_TRUE(contents.ok()) << contents.error().message;
  EXPECT_THAT(contents->missing, HasSubstr("no wrench"));
  std::vector<std::string> names;
  for (const auto& column : contents->proposed) names.push_back(column.column);
  EXPECT_THAT(names, testing::ElementsAre("q1", "q2", "q3", "q4", "q5", "q6"));
}

}  // namespace
}  // namespace heft
