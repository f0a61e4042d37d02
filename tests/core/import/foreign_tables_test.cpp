// Tables of recorders that nobody told of Heft: other languages, layouts of names, and times under any name.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using ForeignTables = InFolder;

constexpr int kRows = 100;

/// Rows of the fixtures' formula at 100 Hz: the time as `time` writes it, seven joints, six of the wrench.
template <class Time>
std::string rows(Time time, char separator = ',', double jointScale = 1.0) {
  std::string out;
  for (int k = 0; k < kRows; ++k) {
    out += time(k);
    for (int j = 0; j < 7; ++j) out += fmt::format("{}{:.9g}", separator, jointScale * jointAt(0.01 * k, j));
    for (int a = 0; a < 6; ++a) out += fmt::format("{}{:.9g}", separator, wrenchAt(0.01 * k, a));
    out += "\n";
  }
  return out;
}

std::string seconds(int k) { return fmt::format("{:.2f}", 0.01 * k); }

/// `form` with 1 to 7, or from `first` on, with the separator before each.
std::string seven(const std::string& form, char separator = ',', int first = 1) {
  std::string out;
  for (int j = first; j < first + 7; ++j) out += separator + fmt::format(fmt::runtime(form), j);
  return out;
}

TEST_F(ForeignTables, AUnitTellsWhatAWordOfAnyLanguageMeans) {
  const std::string spanish = ",fuerza_x (N),fuerza_y (N),fuerza_z (N),par_x (Nm),par_y (Nm),par_z (Nm)\n";
  const std::string french = ",effort_x_N,effort_y_N,effort_z_N,couple_x_Nm,couple_y_Nm,couple_z_Nm\n";
  for (const auto& head : {"tiempo (s)" + seven("eje_{} (rad)") + spanish, "temps_s" + seven("kulma{}_rad") + french}) {
    const auto read = openRecording(write("foreign.csv", head + rows(seconds)));
    ASSERT_TRUE(read.ok()) << head << failureOf(read);
    expectFormula(read->recording);
  }
}

TEST_F(ForeignTables, AWrenchMayCountFromOne) {
  for (const char* names :
       {",F1,F2,F3,M1,M2,M3", ",F_1,F_2,F_3,T_1,T_2,T_3", ",F[0],F[1],F[2],M[0],M[1],M[2]",
        ",sensor_force1,sensor_force2,sensor_force3,sensor_moment1,sensor_moment2,sensor_moment3"}) {
    const auto read = openRecording(write("counted.csv", "time" + seven("q{}") + names + "\n" + rows(seconds)));
    ASSERT_TRUE(read.ok()) << names << failureOf(read);
    expectFormula(read->recording);
  }
}

TEST_F(ForeignTables, DigitsInGroupsOfThree) {
  const auto read = [&](const char* header, const std::function<std::string(double)>& cell) {
    std::string text = header;
    for (int k = 0; k < 400; ++k) {
      const double t = 0.01 * k;
      text += cell(1e3 * t);
      for (int j = 0; j < 7; ++j) text += ";" + cell(0.1 * j + 0.2 * std::sin(t));
      for (int c = 0; c < 6; ++c) text += ";" + cell(1e3 * (c + 1.5));
      text += "\n";
    }
    return openRecording(write("grouped.csv", text));
  };
  const auto grouped = [](double value, char group, char point) {
    std::string out = fmt::format("{:.3f}", std::abs(value));
    const std::size_t dot = out.find('.');
    out[dot] = point;
    for (std::size_t i = dot; i > 3; i -= 3) out.insert(i - 3, 1, group);
    return (value < 0.0 ? "-" : "") + out;
  };
  const char* header = "t [ms];q1;q2;q3;q4;q5;q6;q7;Fx [mN];Fy [mN];Fz [mN];Mx [mNm];My [mNm];Mz [mNm]\n";
  for (const auto& [group, point] : {std::pair{'.', ','}, std::pair{',', '.'}}) {
    const auto all = read(header, [&, g = group, p = point](double value) { return grouped(value, g, p); });
    ASSERT_TRUE(all.ok()) << group << failureOf(all);
    EXPECT_EQ(all->recording.rows(), 400) << group;
    EXPECT_NEAR(all->recording.time(399) - all->recording.time(0), 3.99, 1e-9) << group;
    EXPECT_NEAR(all->recording.wrench(399, 5), 6.5, 1e-9) << group;
  }
}

TEST_F(ForeignTables, TextAmongNumbersIsSaid) {
  std::string text = "t [ms]" + seven("q{}") + ",Fx [N],Fy [N],Fz [N],Mx [Nm],My [Nm],Mz [Nm]\n" +
                     rows([](int k) { return k == 30 ? std::string("broken") : std::to_string(10 * k); });
  const auto read = openRecording(write("damaged.csv", text));
  ASSERT_TRUE(read.ok()) << failureOf(read);
  const auto said = std::ranges::find(read->findings, "cells_no_numbers", &Finding::code);
  ASSERT_NE(said, read->findings.end());
  EXPECT_THAT(said->text, HasSubstr("broken"));
  EXPECT_EQ(said->where.line, 32);
}

TEST_F(ForeignTables, WhatCannotBeReadSaysWhatToDo) {
  EXPECT_THAT(failureOf(openRecording(write("echo.yaml", "header:\n  stamp:\n    sec: 1\n---\nheader:\n  stamp:\n"))),
              HasSubstr("ros2 bag record"));
  EXPECT_THAT(failureOf(openRecording(write("log.pkl", std::string("\x80\x04\x95\0\0\0\0", 7)))),
              HasSubstr("numpy.savez"));
}

TEST_F(ForeignTables, AngleOfATurnedToolIsNoJoint) {
  const auto read =
      openRecording(write("turn.csv", "time" + seven("tool_{}_deg") + ",fx,fy,fz,tx,ty,tz\n" + rows(seconds)));
  EXPECT_THAT(failureOf(read), HasSubstr("no motion"));
}

TEST_F(ForeignTables, TheOneColumnThatRisesEvenlyIsTheTime) {
  const std::string wrench = ",fx,fy,fz,tx,ty,tz\n";
  const auto read = openRecording(write("odd.csv", "duration" + seven("q{}") + wrench + rows(seconds)));
  ASSERT_TRUE(read.ok()) << failureOf(read);
  expectFormula(read->recording);
  EXPECT_TRUE(hasCode(read->findings, "time_guessed"));
  // Row numbers are none, and of two nothing tells which.
  const auto count = [](int k) { return std::to_string(k); };
  EXPECT_THAT(failureOf(openRecording(write("count.csv", "zaehler" + seven("q{}") + wrench + rows(count)))),
              HasSubstr("--rate"));
  const auto two = [](int k) { return fmt::format("{:.2f},{:.3f}", 0.01 * k, 0.011 * k); };
  EXPECT_THAT(failureOf(openRecording(write("two.csv", "one,other" + seven("q{}") + wrench + rows(two)))),
              HasSubstr("--use time=NAME"));
}

TEST_F(ForeignTables, KukasRecorder) {
  const auto split = [](int k) { return fmt::format("{} {}", 1700000000 + k / 100, 10000000 * (k % 100)); };
  const auto read = openRecording(write(
      "sunrise.log", "ZeitInSec ZeitInNanoSec" + seven("axisQMsr_LBR_iiwa_7_R800_1_{}", ' ') +
                         " cartForce1_X cartForce1_Y cartForce1_Z cartForce1_TauX cartForce1_TauY cartForce1_TauZ\n" +
                         rows(split, ' ')));
  ASSERT_TRUE(read.ok()) << failureOf(read);
  expectFormula(read->recording);
}

TEST_F(ForeignTables, LabViewsHeaderHasOneNameMore) {
  const auto read = openRecording(write(
      "labview.lvm", "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\n***End_of_Header***\t\n\t\nX_Value" +
                         seven("Robot J{}", '\t') + "\tFx\tFy\tFz\tTx\tTy\tTz\tComment\n" + rows(seconds, '\t')));
  ASSERT_TRUE(read.ok()) << failureOf(read);
  expectFormula(read->recording);
}

/// pandas writes names of two levels as two rows, a merged cell stands once above several names, and gnuplot's users
/// number the columns in a comment.
TEST_F(ForeignTables, NamesInTwoRowsAndInAListAbove) {
  std::string listed = "# columns:\n# 1: time [s]\n";
  for (int j = 1; j <= 7; ++j) listed += fmt::format("# {}: q{} [rad]\n", j + 1, j);
  int number = 9;
  for (const char* const name : {"Fx [N]", "Fy [N]", "Fz [N]", "Tx [Nm]", "Ty [Nm]", "Tz [Nm]"})
    listed += fmt::format("# {}: {}\n", number++, name);
  for (const auto& head :
       {"time,q,q,q,q,q,q,q,force,force,force,torque,torque,torque\n" + seven("{}", ',', 0) + ",x,y,z,x,y,z\n",
        "time,joint angle,,,,,,,force,,,torque,,\n" + seven("{}") + ",x,y,z,x,y,z\n", listed}) {
    const char separator = head[0] == '#' ? ' ' : ',';
    const auto read = openRecording(write("names.txt", head + rows(seconds, separator)));
    ASSERT_TRUE(read.ok()) << head << failureOf(read);
    expectFormula(read->recording);
  }
}

TEST_F(ForeignTables, JsonMayWriteNumbersAndDatesAsText) {
  std::string text;
  for (int k = 0; k < kRows; ++k) {
    const double t = 0.01 * k;
    text += fmt::format(R"({{"ts": "2026-11-20T10:00:{:05.2f}Z", "payload": {{"joints": {{)", t);
    for (int j = 0; j < 7; ++j)
      text += fmt::format(R"({}"panda_joint{}": "{:.9g}")", j > 0 ? ", " : "", j + 1, jointAt(t, j));
    text += "}, \"ft\": [";
    for (int a = 0; a < 6; ++a) text += fmt::format("{}{:.9g}", a > 0 ? ", " : "", wrenchAt(t, a));
    text += "]}}\n";
  }
  const auto read = openRecording(write("broker.jsonl", text));
  ASSERT_TRUE(read.ok()) << failureOf(read);
  expectFormula(read->recording);
}

/// Beside angles of the same tool, x, y and z are its place.
TEST_F(ForeignTables, APlaceBesideItsAngles) {
  std::string text = "time,tcp_x_mm,tcp_y_mm,tcp_z_mm,tcp_yaw_deg,tcp_pitch_deg,tcp_roll_deg,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < kRows; ++k)
    text += fmt::format("{:.2f},100,200,{},{},0,0,1,2,3,0.1,0.2,0.3\n", 0.01 * k, 300 + k, 0.5 * k);
  const auto read = openRecording(write("tcp.csv", text));
  ASSERT_TRUE(read.ok()) << failureOf(read);
  ASSERT_TRUE(read->recording.hasPosition());
  EXPECT_NEAR(read->recording.position(50, 0), 0.1, 1e-9);
  EXPECT_NEAR(read->recording.position(50, 2), 0.350, 1e-9);
  EXPECT_NEAR(read->recording.quaternion(50, 2), std::sin(0.5 * 25.0 * kDegree), 1e-6);
}

/// Numbered columns under a name that could be anything are taken as a group where the user says what they are.
TEST_F(ForeignTables, ANumberedGroupIsChosenByWhatItsNamesShare) {
  const auto file = write("state.csv", "timestamp" + seven("observation.state.{}", ',', 0) +
                                           ",extra.0,extra.1,extra.2,extra.3,extra.4,extra.5\n" + rows(seconds));
  EXPECT_THAT(failureOf(openRecording(file)), HasSubstr("--use"));
  ImportOptions options;
  options.use = {"joints=observation.state", "wrench=extra"};
  const auto read = openRecording(file, options);
  ASSERT_TRUE(read.ok()) << failureOf(read);
  expectFormula(read->recording);
  options.use = {"joints=observation.state", "wrench=observation.state"};
  EXPECT_THAT(failureOf(openRecording(file, options)), HasSubstr("has no wrench"));
}

}  // namespace
}  // namespace heft
