// Files as strangers have them, one small input for each thought that once was missing.
#include <fmt/format.h>

#include "core/math/rigid.h"
#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Strangers = InFolder;

const std::vector<std::string> kUr = {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint",
                                      "wrist_1_joint",      "wrist_2_joint",       "wrist_3_joint"};

/// Positions and velocities of seven joints and a wrench that comes half as often: the first row holds nothing of it.
TEST_F(Strangers, ARowMayLackMostSeries) {
  std::string text = "__time";
  for (const char* const kind : {"position", "velocity"})
    for (int j = 1; j <= 7; ++j) text += fmt::format(",/joint_states/panda_joint{}/{}", j, kind);
  for (const char* const name : {"force/x", "force/y", "force/z", "torque/x", "torque/y", "torque/z"})
    text += fmt::format(",/ft/wrench/{}", name);
  text += "\n";
  for (int k = 0; k < 400; ++k) {
    const double t = 0.0025 * k;
    const bool wrench = k % 4 == 3, joints = k % 2 == 0;
    if (!wrench && !joints) continue;
    text += fmt::format("{:.6f}", 1.7e9 + t);
    for (int j = 0; j < 7; ++j) text += joints ? fmt::format(",{:.9f}", jointAt(t, j)) : ",";
    for (int j = 0; j < 7; ++j) text += joints ? fmt::format(",{:.9f}", 0.6 * std::cos(3.0 * t + j)) : ",";
    for (int a = 0; a < 6; ++a) text += !wrench ? "," : fmt::format(",{:.9f}", wrenchAt(t, a));
    text += "\n";
  }
  const auto read = openRecording(write("plot.csv", text));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->recording.dq.cols(), 7);
  const auto& recording = read->recording;
  for (Eigen::Index k = 0; k < recording.rows(); ++k)
    EXPECT_NEAR(recording.wrench(k, 1), wrenchAt(recording.time(k) + 0.0, 1), 2e-3);
}

/// rosbridge's messages one a line: an arm of any names with a gripper on its topic, and two topics of one type.
TEST_F(Strangers, TopicsInJsonLinesAreToldApart) {
  std::string text;
  const auto line = [&](const std::string& topic, int k, const std::string& content) {
    text += fmt::format(R"({{"op":"publish","topic":"{}","msg":{{"header":{{"stamp":{{"secs":{},"nsecs":{}}}}},{}}}}})"
                        "\n",
                        topic, 1700000000 + k / 100, 10000000 * (k % 100), content);
  };
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    std::string names, positions;
    for (const int j : {2, 1, 0, 3, 4, 5}) {
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ",", kUr[static_cast<std::size_t>(j)]);
      positions += fmt::format("{}{:.9f}", positions.empty() ? "" : ",", jointAt(t, j));
    }
    line("/joint_states", k,
         fmt::format(R"("name":[{}],"position":[{}],"velocity":[null,null,null,null,null,null],"effort":[])", names,
                     positions));
    if (k % 5 == 0) line("/joint_states", k, R"("name":["finger_joint"],"position":[0.3],"velocity":[],"effort":[])");
    for (const auto& [topic, size] : {std::pair{"/ft/filtered", 0.5}, {"/ft/raw", 1.0}})
      line(
          topic, k,
          fmt::format(
              R"("wrench":{{"force":{{"x":{:.9f},"y":{:.9f},"z":{:.9f}}},"torque":{{"x":{:.9f},"y":{:.9f},"z":{:.9f}}}}})",
              size * wrenchAt(t, 0), size * wrenchAt(t, 1), size * wrenchAt(t, 2), size * wrenchAt(t, 3),
              size * wrenchAt(t, 4), size * wrenchAt(t, 5)));
  }
  const auto read = openRecording(write("bridge.jsonl", text));
  // Without a robot the arm is understood all the same: UR's names are known.
  EXPECT_THAT(failureOf(read), HasSubstr("6 joints but no robot"));
  const auto contents = inspectRecording(write("bridge.jsonl", text));
  ASSERT_TRUE(contents.ok());
  std::vector<std::string> sources;
  for (const auto& column : contents->chosen)
    sources.push_back(column.column + " " + contents->streams[column.stream].fields[column.field]);
  EXPECT_THAT(sources, testing::Contains("q1 /joint_states/position[shoulder_pan_joint]"));
  EXPECT_THAT(sources, testing::Contains("q3 /joint_states/position[elbow_joint]"));
  EXPECT_THAT(sources, testing::Contains("fx /ft/raw/wrench.force.x"));
}

/// X, Y, Z in mm and Q1 to Q4 with the real part first.
TEST_F(Strangers, AnAbbsQuaternionIsNoArmOfFourJoints) {
  std::string text = "Time;X;Y;Z;Q1;Q2;Q3;Q4;Fx;Fy;Fz;Tx;Ty;Tz\n";
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    text += fmt::format("{:.2f};{:.6f};400;-50;{:.9f};{:.9f};0;0", t, 500.0 + 100.0 * t, std::cos(t), std::sin(t));
    for (int a = 0; a < 6; ++a) text += fmt::format(";{:.9f}", wrenchAt(t, a));
    text += "\n";
  }
  const auto read = openRecording(write("abb.csv", text));
  ASSERT_TRUE(read.ok()) << read.error().message;
  const auto& recording = read->recording;
  ASSERT_TRUE(recording.hasPosition());
  for (Eigen::Index k = 0; k < recording.rows(); k += 9) {
    const double t = recording.time(k);
    EXPECT_NEAR(recording.position(k, 0), 0.5 + 0.1 * t, 1e-6);
    EXPECT_NEAR(recording.position(k, 2), -0.05, 1e-9);
    EXPECT_NEAR(recording.quaternion(k, 0), std::sin(t), 1e-6);
    EXPECT_NEAR(recording.quaternion(k, 3), std::cos(t), 1e-6);
  }
}

std::string plainRows(const std::string& time, int count, double step) {
  std::string text = time;
  for (int j = 1; j <= 7; ++j) text += fmt::format(",q{}", j);
  text += ",fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < count; ++k) {
    const double t = 0.01 * k;
    text += fmt::format("{:g}", step * k);
    for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9f}", jointAt(t, j));
    for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9f}", wrenchAt(t, a));
    text += "\n";
  }
  return text;
}

TEST_F(Strangers, RowNumbersAreNoSecondsAndAUnitCanBeStated) {
  const auto counted = write("counted.csv", plainRows("time", 400, 1.0));
  EXPECT_THAT(failureOf(openRecording(counted)), HasSubstr("--rate HZ"));
  ImportOptions options;
  options.rateHz = 100.0;
  const auto withRate = openRecording(counted, options);
  ASSERT_TRUE(withRate.ok()) << withRate.error().message;
  expectFormula(withRate->recording);
  const auto millis = write("millis.csv", plainRows("zaehlerstand", 100, 10.0));
  EXPECT_THAT(failureOf(openRecording(millis)), HasSubstr(R"({"scale": {"time": 0.001}})"));
  write("millis.map.json", R"({"scale": {"time": 0.001}})");
  const auto stated = openRecording(millis);
  ASSERT_TRUE(stated.ok()) << stated.error().message;
  expectFormula(stated->recording);
}

TEST_F(Strangers, StandingPosesInTwoFilesAreJoinedRowByRow) {
  std::string poses, wrench;
  for (int k = 0; k < 8; ++k) {
    const double half = 0.3 * k;
    poses += fmt::format("0.4 0.1 0.5 {:.9f} 0 0 {:.9f}\n", std::sin(half), std::cos(half));
    wrench += fmt::format("{:.6f} 0.2 9.1 0.01 {:.6f} 0.03\n", 1.0 + k, 0.1 * k);
  }
  write("poses.meta.json", R"({"kind": "poses"})");
  ImportOptions options;
  options.join = {write("wrench.txt", wrench)};
  const auto read = openRecording(write("poses.txt", poses), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  ASSERT_EQ(read->recording.rows(), 8);
  for (Eigen::Index k = 0; k < 8; ++k) {
    EXPECT_NEAR(read->recording.wrench(k, 0), 1.0 + static_cast<double>(k), 1e-9);
    EXPECT_NEAR(read->recording.quaternion(k, 0), std::sin(0.3 * static_cast<double>(k)), 1e-6);
  }
  write("wrench.txt", wrench.substr(wrench.find('\n') + 1));
  EXPECT_THAT(failureOf(openRecording(folder_ / "poses.txt", options)), HasSubstr("8 poses"));
}

TEST_F(Strangers, APoseStandsInForJointsOfARobotThatIsNotNamed) {
  std::string text = "timestamp";
  for (int j = 1; j <= 6; ++j) text += fmt::format(",joint_angles_{}", j);
  text += ",pose_tx,pose_ty,pose_tz,pose_qw,pose_qx,pose_qy,pose_qz,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    text += fmt::format("{:.2f}", t);
    for (int j = 0; j < 6; ++j) text += fmt::format(",{:.9f}", jointAt(t, j));
    text += fmt::format(",0.4,0.1,{:.9f},{:.9f},{:.9f},0,0", 0.5 + 0.1 * t, std::cos(t), std::sin(t));
    for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9f}", wrenchAt(t, a));
    text += "\n";
  }
  const auto read = openRecording(write("log.csv", text));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_TRUE(hasCode(read->findings, "pose_for_joints")) << allTexts(read->findings);
  EXPECT_FALSE(read->recording.hasJoints());
  EXPECT_NEAR(read->recording.position(50, 2), 0.55, 1e-6);
}

/// Two arms in one table: the joints go with the sensor's side, their velocities with the joints; where the sensor says
/// no side, that there are two is said.
TEST_F(Strangers, JointsGoWithTheSensorsSide) {
  for (const std::string sensor : {"right_", ""}) {
    std::string text = "time";
    for (const char* const side : {"left", "right"})
      for (const char* const kind : {"", "_velocity"})
        for (int j = 1; j <= 7; ++j) text += fmt::format(",{}_panda_joint{}{}", side, j, kind);
    for (const char* const name : {"fx", "fy", "fz", "tx", "ty", "tz"}) text += fmt::format(",{}ft_{}", sensor, name);
    text += "\n";
    for (int k = 0; k < 100; ++k) {
      const double t = 0.01 * k;
      text += fmt::format("{:.2f}", t);
      for (int arm = 0; arm < 2; ++arm) {
        for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9f}", arm * jointAt(t, j));
        for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9f}", arm * 0.6 * std::cos(3.0 * t + j));
      }
      for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9f}", wrenchAt(t, a));
      text += "\n";
    }
    const auto read = openRecording(write("two.csv", text));
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(hasCode(read->findings, "joints_of_several"), sensor.empty()) << allTexts(read->findings);
    if (sensor.empty()) continue;
    expectFormula(read->recording);
    ASSERT_EQ(read->recording.dq.cols(), 7);
    EXPECT_NEAR(read->recording.dq(10, 0), 0.6 * std::cos(0.3), 1e-6);
  }
}

/// The place of a child frame has plain letters beside its quaternion.
TEST_F(Strangers, AChildFramesPlaceIsItsLetters) {
  std::string text = "stamp,frame_id,child_frame_id,x,y,z,qx,qy,qz,qw,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    text +=
        fmt::format("{:.2f},base,camera,1,2,3,0,0,0,1,,,,,,\n{:.2f},base,ft_sensor,{:.9f},0.1,0.5,{:.9f},0,0,{:.9f}", t,
                    t, 0.4 + t, std::sin(t), std::cos(t));
    for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9f}", wrenchAt(t, a));
    text += "\n";
  }
  ImportOptions options;
  options.use = {"quaternion=ft_sensor"};
  const auto read = openRecording(write("frames.csv", text), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  ASSERT_TRUE(read->recording.hasPosition());
  EXPECT_NEAR(read->recording.position(50, 0), 0.9, 1e-6);
}

}  // namespace
}  // namespace heft
