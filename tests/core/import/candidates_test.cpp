// Guesses from names: what is taken, and what never is.
#include <fmt/format.h>

#include <algorithm>

#include "core/import/mapping.h"
#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

Stream streamOf(const std::string& name, const std::string& type, std::vector<std::string> fields,
                std::size_t samples = 100) {
  Stream out;
  out.name = name;
  out.type = type;
  out.fields = std::move(fields);
  out.samples = samples;
  return out;
}

std::vector<std::string> numbered(const std::string& name, int count) {
  std::vector<std::string> out;
  for (int i = 0; i < count; ++i) out.push_back(fmt::format("{}[{}]", name, i));
  return out;
}

void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Field that a column is read from; empty if it is not read.
std::string fieldOf(const std::vector<Stream>& streams, const std::vector<ColumnSource>& chosen,
                    const std::string& name) {
  for (const auto& column : chosen)
    if (column.column == name) return streams[column.stream].name + ":" + streams[column.stream].fields[column.field];
  return {};
}

const std::vector<std::string> kWrench = {"wrench.force.x",  "wrench.force.y",  "wrench.force.z",
                                          "wrench.torque.x", "wrench.torque.y", "wrench.torque.z"};

TEST(Candidates, FrankaStateGivesMeasuredJointsAndNoWrench) {
  std::vector<std::string> fields;
  for (const char* const name :
       {"q_d", "q", "dq_d", "dq", "ddq_d", "tau_J", "theta", "joint_contact", "tau_ext_hat_filtered"})
    append(fields, numbered(name, 7));
  append(fields, numbered("O_F_ext_hat_K", 6));
  append(fields, numbered("K_F_ext_hat_K", 6));
  append(fields, numbered("O_T_EE", 16));
  std::vector<Stream> streams = {streamOf("/franka_states", "franka_msgs/FrankaState", fields)};
  Findings findings;
  EXPECT_FALSE(chooseColumns(streams, {}, {}, findings).ok()) << "an external wrench is no sensor's";
  streams.push_back(streamOf("/ft", "geometry_msgs/WrenchStamped", kWrench));
  const auto chosen = chooseColumns(streams, {}, {}, findings);
  ASSERT_TRUE(chosen.ok()) << chosen.error().message;
  EXPECT_EQ(fieldOf(streams, *chosen, "q1"), "/franka_states:q[0]");
  EXPECT_EQ(fieldOf(streams, *chosen, "dq7"), "/franka_states:dq[6]");
  EXPECT_EQ(fieldOf(streams, *chosen, "tz"), "/ft:wrench.torque.z");
}

TEST(Candidates, FrankaRobotStateHasItsJointsNested) {
  std::vector<std::string> fields;
  for (const char* const state : {"desired_joint_state", "measured_joint_motor_state", "measured_joint_state"})
    for (const char* const quantity : {"position", "velocity", "effort"})
      for (int j = 1; j <= 7; ++j) fields.push_back(fmt::format("{}.{}[fr3_joint{}]", state, quantity, j));
  for (const auto& name : kWrench) fields.push_back("k_f_ext_hat_k." + name);
  const std::vector<Stream> streams = {streamOf("/state", "franka_msgs/FrankaRobotState", fields),
                                       streamOf("/ft", "geometry_msgs/WrenchStamped", kWrench, 20)};
  Findings findings;
  const auto chosen = chooseColumns(streams, {}, {}, findings);
  ASSERT_TRUE(chosen.ok()) << chosen.error().message;
  EXPECT_EQ(fieldOf(streams, *chosen, "q3"), "/state:measured_joint_state.position[fr3_joint3]");
  EXPECT_EQ(fieldOf(streams, *chosen, "dq3"), "/state:measured_joint_state.velocity[fr3_joint3]");
  EXPECT_EQ(fieldOf(streams, *chosen, "fx"), "/ft:wrench.force.x");
}

TEST(Candidates, TheRawWrenchBeatsTheCompensatedOne) {
  const std::vector<Stream> streams = {
      streamOf("/ft_compensated", "geometry_msgs/WrenchStamped", kWrench, 1000),
      streamOf("/ft_raw", "geometry_msgs/WrenchStamped", kWrench, 100),
      streamOf("/pose", "geometry_msgs/PoseStamped",
               {"pose.position.x", "pose.position.y", "pose.position.z", "pose.orientation.x", "pose.orientation.y",
                "pose.orientation.z", "pose.orientation.w"})};
  Findings findings;
  auto chosen = chooseColumns(streams, {}, {}, findings);
  ASSERT_TRUE(chosen.ok()) << chosen.error().message;
  EXPECT_EQ(fieldOf(streams, *chosen, "fx"), "/ft_raw:wrench.force.x");
  EXPECT_EQ(fieldOf(streams, *chosen, "qw"), "/pose:pose.orientation.w");
  EXPECT_EQ(fieldOf(streams, *chosen, "pz"), "/pose:pose.position.z");
  MappingWishes wishes;
  wishes.use["wrench"] = "/ft_compensated";
  chosen = chooseColumns(streams, wishes, {}, findings);
  ASSERT_TRUE(chosen.ok());
  EXPECT_EQ(fieldOf(streams, *chosen, "fx"), "/ft_compensated:wrench.force.x");
}

TEST(Candidates, AKnownArmsJointsAreFoundByTheirNames) {
  const std::vector<std::string> names = {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint",
                                          "wrist_1_joint",      "wrist_2_joint",       "wrist_3_joint"};
  std::vector<std::string> fields;
  for (const auto& name : {names[2], names[1], names[0], names[3], names[4], names[5]})
    fields.push_back("position[" + name + "]");
  const std::vector<Stream> streams = {streamOf("/js", "sensor_msgs/JointState", fields),
                                       streamOf("/ft", "geometry_msgs/WrenchStamped", kWrench)};
  Findings findings;
  const auto chosen = chooseColumns(streams, {}, names, findings);
  ASSERT_TRUE(chosen.ok()) << chosen.error().message;
  EXPECT_EQ(fieldOf(streams, *chosen, "q1"), "/js:position[shoulder_pan_joint]");
  EXPECT_EQ(fieldOf(streams, *chosen, "q3"), "/js:position[elbow_joint]");
}

/// Of several transforms those that say whose they are come first, and a place goes with its own turn.
TEST(Candidates, TransformsAreToldApartByTheirFrames) {
  std::vector<std::string> fields;
  for (const char* const frame : {"0", "camera_link", "wrist_tool"}) {
    for (const char axis : {'x', 'y', 'z'})
      fields.push_back(fmt::format("transforms[{}].transform.translation.{}", frame, axis));
    for (const char axis : {'x', 'y', 'z', 'w'})
      fields.push_back(fmt::format("transforms[{}].transform.rotation.{}", frame, axis));
  }
  const std::vector<Stream> streams = {streamOf("/tf_static", "tf2_msgs/TFMessage", fields),
                                       streamOf("/tf", "tf2_msgs/TFMessage", fields),
                                       streamOf("/ft", "geometry_msgs/WrenchStamped", kWrench)};
  Findings findings;
  const auto chosen = chooseColumns(streams, {}, {}, findings);
  ASSERT_TRUE(chosen.ok()) << chosen.error().message;
  EXPECT_EQ(fieldOf(streams, *chosen, "qx"), "/tf:transforms[wrist_tool].transform.rotation.x");
  EXPECT_EQ(fieldOf(streams, *chosen, "px"), "/tf:transforms[wrist_tool].transform.translation.x");
  const auto said = std::ranges::find(findings, "transform_as_pose", &Finding::code);
  ASSERT_NE(said, findings.end());
  EXPECT_NE(said->text.find("wrist_tool"), std::string::npos) << said->text;
  MappingWishes wishes;
  wishes.use["quaternion"] = "/tf:camera_link";
  const auto wished = chooseColumns(streams, wishes, {}, findings);
  ASSERT_TRUE(wished.ok()) << wished.error().message;
  EXPECT_EQ(fieldOf(streams, *wished, "pz"), "/tf:transforms[camera_link].transform.translation.z");
}

TEST(Candidates, AnInertialSensorsOwnOrientationIsNoPose) {
  const std::vector<Stream> streams = {
      streamOf("/imu", "sensor_msgs/Imu",
               {"orientation.x", "orientation.y", "orientation.z", "orientation.w", "angular_velocity.x",
                "angular_velocity.y", "angular_velocity.z", "linear_acceleration.x", "linear_acceleration.y",
                "linear_acceleration.z"}),
      streamOf("/ft", "geometry_msgs/WrenchStamped", kWrench)};
  Findings findings;
  EXPECT_FALSE(chooseColumns(streams, {}, {}, findings).ok());
}

}  // namespace
}  // namespace heft
