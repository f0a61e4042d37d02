#pragma once
// What the words of one field's name say that it measures.
#include <algorithm>
#include <optional>
#include <span>
#include <string>

#include "core/import/field_name.h"

namespace heft {

/// What a field seems to be: an index among its kin, and which words make its name's family.
struct Member {
  int index = 0;
  Words family;
};
struct PoseMember : Member {
  bool quaternion = false;
};
struct JointMember : Member {
  bool velocity = false;
};
struct InertialMember : Member {
  bool rates = false;
};

bool anyIs(const Words& tokens, std::span<const char* const> words);
bool isDigits(const std::string& word);

/// Whether it is a value that nobody measured: a command, a limit, an error.
bool isCommanded(const Words& words);
/// Whether something was taken away from a wrench, or no sensor measured it.
bool isProcessed(const Words& words);
/// What speaks against one of several sources that are otherwise alike: raw comes before what was made of it, and the
/// sensor's own axes before others.
int doubtOf(const Words& words);

/// 0..5 of a wrench: "fx", "force x", "wrench.torque.z", "ft[3]", "Fx_raw", "couple_x (Nm)".
std::optional<Member> asWrench(const FieldName& name);
/// The same of names that count from one: "F1", "F_3", "moment2".
std::optional<Member> asWrenchFromOne(const Words& words);
/// An element of an array of six: "ft_raw_wrench_0", "fts_reading_1", "actual_TCP_force_5", "forceTorque[3]".
std::optional<Member> asWrenchArray(const Words& words);
/// 0..2 of a place, or 0..3 (x, y, z, w) of a quaternion.
std::optional<PoseMember> asPose(const Words& words);
/// Elements of a rotation matrix by rows, "r11" to "r33" or "R[0][2]".
std::optional<Member> asMatrix(const Words& words);
/// The number of a joint, as it stands; a numbered column in degrees or radians is one, whatever its words.
std::optional<JointMember> asJoint(const FieldName& name);
/// 0..2 of an accelerometer ("ax", "linear_acceleration.x", "imu_acc_y", UR's "actual_tool_accelerometer_2") or of a
/// gyroscope ("angular_velocity.x", "gyro_z", "wx").
std::optional<InertialMember> asInertial(const Words& words);
/// UR's controller takes the configured payload off this force, and turns it into its base's axes.
bool isTcpForce(const Words& words);

}  // namespace heft
