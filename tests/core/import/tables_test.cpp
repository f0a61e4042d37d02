// Tables as other programs write them.
#include <fmt/format.h>

#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;
using Tables = InFolder;

constexpr double kStartSeconds = 1700000000.0;

TEST_F(Tables, PlotJugglerLeavesCellsEmptyWhereItMerges) {
  for (const char separator : {',', ';', '\t', ' '}) {
    if (separator == ' ') continue;  // blanks cannot tell empty cells
    std::string text = "__time";
    for (int j = 1; j <= 7; ++j) text += fmt::format("{}/joint_states/panda_joint{}/position", separator, j);
    for (const char* const name : {"force/x", "force/y", "force/z", "torque/x", "torque/y", "torque/z"})
      text += fmt::format("{}/ft/wrench/{}", separator, name);
    text += fmt::format("{}/joint_states/panda_joint1/effort\n", separator);
    for (int k = 0; k < 400; ++k) {
      const double t = k * 0.0025;
      const bool joints = k % 4 == 1;
      const bool wrench = k % 2 == 0;
      text += fmt::format("{:.6f}", kStartSeconds + t);
      for (int j = 0; j < 7; ++j)
        text += joints ? fmt::format("{}{:.9f}", separator, jointAt(t, j)) : std::string(1, separator);
      for (int a = 0; a < 6; ++a)
        text += wrench ? fmt::format("{}{:.9f}", separator, wrenchAt(t, a)) : std::string(1, separator);
      text += joints ? fmt::format("{}0.5\n", separator) : fmt::format("{}\n", separator);
    }
    const auto read = openRecording(write("plot.csv", text));
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_NEAR(read->recording.rateHz(), 100.0, 0.1);
    expectFormula(read->recording, 0.0025);
  }
}

std::string jointsOfRostopic(const std::vector<std::string>& names) {
  std::string text = "%time,field.header.seq,field.header.stamp,field.header.frame_id";
  for (std::size_t j = 0; j < names.size(); ++j) text += fmt::format(",field.name{}", j);
  for (std::size_t j = 0; j < names.size(); ++j) text += fmt::format(",field.position{}", j);
  text += "\n";
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    text += fmt::format("{:.0f},{},{:.0f},", 1e9 * (kStartSeconds + t + 0.003), k, 1e9 * (kStartSeconds + t));
    for (const auto& name : names) text += "," + name;
    for (const auto& name : names) {
      const int joint = name.back() - '1';
      text += fmt::format(",{:.9f}", name.find("finger") != std::string::npos ? 0.04 : jointAt(t, joint));
    }
    text += "\n";
  }
  return text;
}

TEST_F(Tables, RostopicEchoIsJoinedWithTheWrench) {
  std::vector<std::string> names = {"panda_finger_joint1"};
  for (int j = 1; j <= 7; ++j) names.push_back(fmt::format("panda_joint{}", j));
  const auto joints = write("joints.csv", jointsOfRostopic(names));
  std::string text =
      "%time,field.header.seq,field.header.stamp,field.header.frame_id,field.wrench.force.x,"
      "field.wrench.force.y,field.wrench.force.z,field.wrench.torque.x,field.wrench.torque.y,"
      "field.wrench.torque.z\n";
  for (int k = 0; k < 200; ++k) {
    const double t = 0.005 * k;
    text += fmt::format("{:.0f},{},{:.0f},ft", 1e9 * (kStartSeconds + t + 0.002), k, 1e9 * (kStartSeconds + t));
    for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9f}", wrenchAt(t, a));
    text += "\n";
  }
  const auto wrench = write("wrench.csv", text);
  ImportOptions options;
  options.join = {wrench};
  const auto read = openRecording(joints, options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
  EXPECT_EQ(read->recording.rows(), 100);

  const auto alone = openRecording(joints);
  ASSERT_FALSE(alone.ok());
  EXPECT_THAT(alone.error().message, ::testing::HasSubstr("--join"));
}

TEST_F(Tables, RobotStateLinesKeepTheirMilliseconds) {
  std::string lines;
  for (int k = 0; k < 300; ++k) {
    const double t = 0.001 * k;
    std::string q, dq;
    for (int j = 0; j < 7; ++j) {
      q += fmt::format("{}{:.9f}", j == 0 ? "" : ",", jointAt(t, j));
      dq += fmt::format("{}{:.9f}", j == 0 ? "" : ",", 0.6 * std::cos(3.0 * t + j));
    }
    lines += fmt::format(
        "{{\"O_T_EE\": [1,0,0,0,0,1,0,0,0,0,1,0,0.3,0,0.5,1], \"q\": [{}], \"q_d\": [0,0,0,0,0,0,0], \"dq\": [{}], "
        "\"tau_J\": [1,2,3,4,5,6,7], \"O_F_ext_hat_K\": [1,2,3,4,5,6], \"robot_mode\": \"Move\", \"time\": {}}}\n",
        q, dq, 5000 + k);
  }
  std::string wrench = "time,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 300; ++k) {
    wrench += fmt::format("{:.3f}", 0.001 * k);
    for (int a = 0; a < 6; ++a) wrench += fmt::format(",{:.9f}", wrenchAt(0.001 * k, a));
    wrench += "\n";
  }
  const auto states = write("state.jsonl", lines);
  ASSERT_EQ(*recognise(states), FileKind::jsonLines);
  const auto alone = openRecording(states);
  ASSERT_FALSE(alone.ok());
  EXPECT_THAT(alone.error().message, ::testing::HasSubstr("wrench"));
  // The robot's clock and that of the wrench have nothing in common, and here no payload tells: the user must.
  ImportOptions options;
  options.join = {write("wrench.csv", wrench)};
  EXPECT_FALSE(openRecording(states, options).ok());
  options.mapFile = write("map.json", R"({"offset_s": {"wrench.csv": 5.0}})");
  const auto read = openRecording(states, options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_NEAR(read->recording.rateHz(), 1000.0, 1.0);
  EXPECT_NEAR(read->recording.time(0), 5.0, 1e-9);
  expectFormula(read->recording, -5.0);
  ASSERT_EQ(read->recording.dq.cols(), 7);
}

TEST_F(Tables, LibfrankaLogsHaveMillisecondsToo) {
  std::string text = "time,success_rate";
  for (const char* const name : {"state.q", "state.q_d", "state.dq", "state.tau_J", "cmd.q"})
    for (int j = 0; j < 7; ++j) text += fmt::format(",{}[{}]", name, j);
  text += ",fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 200; ++k) {
    const double t = 0.001 * k;
    text += fmt::format("{},1.0", 100 + k);
    for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9f}", jointAt(t, j));
    for (int i = 0; i < 7; ++i) text += ",9.0";
    for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9f}", 0.6 * std::cos(3.0 * t + j));
    for (int i = 0; i < 14; ++i) text += ",8.0";
    for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9f}", wrenchAt(t, a));
    text += "\n";
  }
  const auto path = write("log.csv", text);
  ImportOptions options;
  options.use = {"wrench=log.csv"};
  const auto read = openRecording(path, options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_NEAR(read->recording.time(0), 0.1, 1e-9);
  EXPECT_NEAR(read->recording.rateHz(), 1000.0, 1.0);
  expectFormula(read->recording, -0.1);
}

TEST_F(Tables, WithoutMotionOrTimeSayWhatIsMissing) {
  const auto noMotion = openRecording(write("a.csv",
                                            "__time,/ft/force/x,/ft/force/y,/ft/force/z,/ft/torque/x,"
                                            "/ft/torque/y,/ft/torque/z\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n"));
  ASSERT_FALSE(noMotion.ok());
  EXPECT_THAT(noMotion.error().message, ::testing::HasSubstr("motion"));
  const auto noTime = openRecording(write("b.csv", "/a/x,/a/y\n1,2\n3,4\n"));
  ASSERT_FALSE(noTime.ok());
  EXPECT_THAT(noTime.error().message, ::testing::HasSubstr("time"));
}

TEST_F(Tables, ContractFilesStayWithTheirReader) {
  EXPECT_EQ(*recognise(write("rec.csv", "time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz,note/x\n")),
            FileKind::contractCsv);
  EXPECT_EQ(*recognise(write("m.json", "{\n \"robot\": \"panda\"\n}\n")), FileKind::contractCsv);
}

TEST_F(Tables, EstimatesOfTheControllerAreNotTakenForASensor) {
  std::string lines = "__time";
  for (int j = 1; j <= 7; ++j) lines += fmt::format(",/js/panda_joint{}/position", j);
  for (const char* const name : {"force/x", "force/y", "force/z", "torque/x", "torque/y", "torque/z"})
    lines += fmt::format(",/franka/F_ext/{}", name);
  lines += "\n";
  for (int k = 0; k < 50; ++k) {
    lines += fmt::format("{}", 0.01 * k);
    for (int j = 0; j < 7; ++j) lines += fmt::format(",{}", jointAt(0.01 * k, j));
    for (int a = 0; a < 6; ++a) lines += fmt::format(",{}", wrenchAt(0.01 * k, a));
    lines += "\n";
  }
  const auto read = openRecording(write("ext.csv", lines));
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message, ::testing::HasSubstr("estimate"));
}

/// A contract CSV whose force is called otherwise, with labels: contact from 0.3 s to 0.6 s, nothing before 0.1 s.
std::string labelled(const std::string& contact) {
  std::string text = "time";
  for (int j = 1; j <= 7; ++j) text += fmt::format(",q{}", j);
  text += ",push_x,push_y,push_z,tx,ty,tz,label\n";
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    text += fmt::format("{:.3f}", t);
    for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9f}", jointAt(t, j));
    for (int a = 0; a < 6; ++a) text += fmt::format(",{:.9f}", wrenchAt(t, a));
    text += std::string(",") + (k < 10 ? "" : k >= 30 && k < 60 ? contact : "free") + "\n";
  }
  return text;
}

TEST_F(Tables, LabelsStayWhereColumnsAreChosen) {
  ImportOptions options;
  options.use = {"fx=push_x", "fy=push_y", "fz=push_z", "tx=tx", "ty=ty", "tz=tz"};
  const auto read = openRecording(write("labelled.csv", labelled("contact")), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
  const auto& labels = read->recording.labels;
  ASSERT_EQ(labels.size(), 100u);
  for (std::size_t k = 0; k < labels.size(); ++k) {
    if (k < 10)
      EXPECT_FALSE(labels[k]) << k;
    else
      EXPECT_EQ(labels[k], k >= 30 && k < 60 ? MarkLabel::contact : MarkLabel::free) << k;
  }
  EXPECT_FALSE(hasCode(read->findings, "label_unknown"));

  const auto odd = openRecording(write("odd.csv", labelled("touching")), options);
  ASSERT_TRUE(odd.ok());
  EXPECT_TRUE(hasCode(odd->findings, "label_unknown")) << allTexts(odd->findings);
  EXPECT_FALSE(odd->recording.labels[40]);
  EXPECT_EQ(odd->recording.labels[70], MarkLabel::free);
}

TEST_F(Tables, LabelsOfOneFileFollowItsClock) {
  // The wrench comes from another file at twice the rate; both clocks count from 1970.
  std::string joints = "time", wrench = "time,fx,fy,fz,tx,ty,tz\n";
  for (int j = 1; j <= 7; ++j) joints += fmt::format(",q{}", j);
  joints += ",label\n";
  for (int k = 0; k < 100; ++k) {
    joints += fmt::format("{:.3f}", kStartSeconds + 0.01 * k);
    for (int j = 0; j < 7; ++j) joints += fmt::format(",{:.9f}", jointAt(0.01 * k, j));
    joints += k >= 50 ? ",ignore\n" : ",free\n";
  }
  for (int k = 0; k < 200; ++k) {
    wrench += fmt::format("{:.3f}", kStartSeconds + 0.005 * k);
    for (int a = 0; a < 6; ++a) wrench += fmt::format(",{:.9f}", wrenchAt(0.005 * k, a));
    wrench += "\n";
  }
  ImportOptions options;
  options.join = {write("wrench.csv", wrench)};
  const auto read = openRecording(write("joints.csv", joints), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  const auto& recording = read->recording;
  ASSERT_EQ(static_cast<Eigen::Index>(recording.labels.size()), recording.rows());
  for (Eigen::Index k = 0; k < recording.rows(); ++k)
    EXPECT_EQ(recording.labels[static_cast<std::size_t>(k)],
              recording.time(k) > 0.4999 ? MarkLabel::ignore : MarkLabel::free)
        << recording.time(k);
}

}  // namespace
}  // namespace heft
