// Topics on which messages differ: several publishers, parts that are empty, encodings that nobody reads. The MCAP
// files are written here, record by record from the specification, with JSON messages.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "core/robot/robot_model.h"
#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Publishers = InFolder;

constexpr std::int64_t kStartNanoseconds = 1'700'000'000'000'000'000;

/// An MCAP file without chunks and index.
class McapText {
 public:
  void channel(std::uint16_t id, const std::string& topic, const std::string& type,
               const std::string& encoding = "json") {
    record(3, number(id) + text(type) + text("jsonschema") + text("{}"));
    record(4, number(id) + number(id) + text(topic) + text(encoding) + number(std::uint32_t{0}));
  }
  void message(std::uint16_t channel, std::int64_t time, const std::string& content) {
    record(5, number(channel) + number(std::uint32_t{0}) + number(time) + number(time) + content);
  }
  std::string bytes() const { return out_; }

 private:
  template <class T>
  static std::string number(T value) {
    const auto bits = std::bit_cast<std::array<char, sizeof(T)>>(value);
    return {bits.begin(), bits.end()};
  }
  static std::string text(const std::string& content) {
    return number(static_cast<std::uint32_t>(content.size())) + content;
  }
  void record(char op, const std::string& content) {
    out_ += op + number(static_cast<std::uint64_t>(content.size())) + content;
  }
  std::string out_ = "\x89MCAP0\r\n" + std::string("\x01\x08\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 17);
};

std::string list(const std::vector<std::string>& items) { return fmt::format("[{}]", fmt::join(items, ",")); }

/// A JointState of the fixtures' formula at `t`; `velocity` is what stands for each joint's.
std::string arm(double t, const std::string& velocity = "", bool zeros = false) {
  std::vector<std::string> names, positions, velocities;
  for (int j = 0; j < 7; ++j) {
    names.push_back(fmt::format("\"panda_joint{}\"", j + 1));
    positions.push_back(zeros ? "0" : fmt::format("{:.12g}", jointAt(t, j)));
    if (!velocity.empty()) velocities.push_back(velocity);
  }
  return fmt::format(R"({{"name":{},"position":{},"velocity":{}}})", list(names), list(positions), list(velocities));
}

std::string wrenchMessage(double t) {
  return fmt::format(
      R"({{"wrench":{{"force":{{"x":{:.12g},"y":{:.12g},"z":{:.12g}}},"torque":{{"x":{:.12g},"y":{:.12g},"z":{:.12g}}}}}}})",
      wrenchAt(t, 0), wrenchAt(t, 1), wrenchAt(t, 2), wrenchAt(t, 3), wrenchAt(t, 4), wrenchAt(t, 5));
}

/// Joints and wrench at 100 Hz for one second; `other(k)` may give another message on the joints' topic before each.
template <class Other>
std::string bag(Other other, const std::string& velocity = "") {
  McapText out;
  out.channel(1, "/joint_states", "sensor_msgs/JointState");
  out.channel(2, "/ft", "geometry_msgs/WrenchStamped");
  for (int k = 0; k < 100; ++k) {
    const double t = 0.01 * k;
    const std::int64_t now = kStartNanoseconds + 10'000'000LL * k;
    if (const std::string more = other(k); !more.empty()) out.message(1, now - 3'000'000, more);
    out.message(1, now, arm(t, velocity));
    out.message(2, now, wrenchMessage(t));
  }
  return out.bytes();
}

std::string nothing(int) { return {}; }

TEST_F(Publishers, AGripperThatSpeaksFirstIsNoArm) {
  const auto path = write("gripper.mcap", bag([](int k) -> std::string {
                            if (k % 3 != 0) return {};
                            return R"({"name":["finger_joint"],"position":[0.02],"velocity":[0]})";
                          }));
  const auto read = openRecording(path);
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
  EXPECT_THAT(allTexts(read->findings), HasSubstr("finger_joint"));
}

TEST_F(Publishers, ZerosBetweenTheArmsOwnStatesAreAnothers) {
  const auto read =
      openRecording(write("zeros.mcap", bag([](int k) { return k % 5 == 2 ? arm(0.0, "", true) : std::string(); })));
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
  EXPECT_TRUE(hasCode(read->findings, "other_publisher"));
}

TEST_F(Publishers, VelocitiesThatAreNullOrEmptyAreLeftAside) {
  const auto null = openRecording(write("null.mcap", bag(&nothing, "null")));
  ASSERT_TRUE(null.ok()) << null.error().message;
  expectFormula(null->recording);
  EXPECT_EQ(null->recording.dq.rows(), 0);
  EXPECT_TRUE(hasCode(null->findings, "columns_set_aside"));
  const auto empty = openRecording(write("empty.mcap", bag(&nothing)));
  ASSERT_TRUE(empty.ok()) << empty.error().message;
  expectFormula(empty->recording);
}

TEST_F(Publishers, WhatExplainsAFailureIsSaidWithIt) {
  McapText out;
  out.channel(1, "/joints", "my.Joints", "protobuf");
  out.message(1, kStartNanoseconds, "\x08\x01");
  const auto read = openRecording(write("protobuf.mcap", out.bytes()));
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message, HasSubstr("\"protobuf\""));
  EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
}

TEST_F(Publishers, TimesThatAreNoneAreCountedAndLeftOut) {
  McapText out;
  out.channel(1, "/joint_states", "sensor_msgs/JointState");
  out.message(1, -1, arm(0.0));  // 2^64 - 1
  out.message(1, std::int64_t{1} << 62, arm(0.0));
  const auto contents = inspectRecording(write("times.mcap", out.bytes()));
  ASSERT_TRUE(contents.ok()) << contents.error().message;
  EXPECT_TRUE(hasCode(contents->findings, "time_impossible")) << allTexts(contents->findings);
}

TEST_F(Publishers, ADelayOfSecondsIsFoundAndCanBeStatedBack) {
  McapText out;
  out.channel(1, "/joint_states", "sensor_msgs/JointState");
  out.channel(2, "/ft", "geometry_msgs/WrenchStamped");
  const auto& panda = RobotModel::panda();
  const auto link = *panda.findLink("panda_link8");
  constexpr double kLate = 2.4;  // [s]
  VectorXd q(7);
  const auto at = [&](double when) {
    // Never twice alike, so that one delay fits only.
    q << 0.0, -0.785, 0.0, -2.356, std::sin(0.9 * when) + 0.3 * std::sin(2.3 * when),
        1.571 + 0.7 * std::sin(0.05 * when * when), 0.785 + std::sin(0.7 * when);
    return panda.linkPose(q, link);
  };
  // Of one kilogram at the flange: its weight, and what accelerates it.
  const auto forceAt = [&](double when) -> Vector3d {
    constexpr double kStep = 1e-3;  // [s]
    const Vector3d before = at(when - kStep).translation(), after = at(when + kStep).translation();
    const auto now = at(when);
    return now.linear().transpose() *
           ((before - 2.0 * now.translation() + after) / (kStep * kStep) + Vector3d(0.0, 0.0, 9.81));
  };
  for (int k = 0; k < 2000; ++k) {
    const double t = 0.01 * k;
    at(t);
    std::vector<std::string> names, positions;
    for (int j = 0; j < 7; ++j) {
      names.push_back(fmt::format("\"panda_joint{}\"", j + 1));
      positions.push_back(fmt::format("{:.12g}", q(j)));
    }
    out.message(1, kStartNanoseconds + 10'000'000LL * k,
                fmt::format(R"({{"name":{},"position":{}}})", list(names), list(positions)));
    const Vector3d weight = forceAt(t - kLate);
    out.message(
        2, kStartNanoseconds + 10'000'000LL * k,
        fmt::format(
            R"({{"wrench":{{"force":{{"x":{:.9g},"y":{:.9g},"z":{:.9g}}},"torque":{{"x":0.1,"y":0.2,"z":{:.9g}}}}}}})",
            weight(0), weight(1), weight(2), 0.01 * std::sin(t)));
  }
  const auto path = write("late.mcap", out.bytes());
  const auto read = openRecording(path);
  ASSERT_TRUE(read.ok()) << read.error().message;
  std::string remedyText;
  for (const auto& finding : read->findings)
    if (finding.code == "time_offset_estimated") remedyText = finding.text + finding.remedy;
  EXPECT_THAT(remedyText, HasSubstr("\"/ft\": -2.4")) << allTexts(read->findings);
  // Stated back, the force fits the motion.
  write("late.map.json", fmt::format(R"({{"offset_s": {{"/ft": {}}}}})", -kLate));
  const auto mended = openRecording(path);
  ASSERT_TRUE(mended.ok()) << mended.error().message;
  const auto& recording = mended->recording;
  for (Eigen::Index k = 100; k < recording.rows(); k += 300) {
    EXPECT_NEAR((recording.wrench.row(k).head<3>().transpose() - forceAt(recording.time(k))).norm(), 0.0, 0.05);
  }
}

}  // namespace
}  // namespace heft
