#pragma once
// How the numbers of a recording are to be understood, and a motion understood in another way than stated.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/motion/motion.h"
#include "core/recording/conventions.h"
#include "core/recording/recording.h"

namespace heft::conventions {

/// Everything that a setup file says about what the numbers mean, and what a mount or a base may turn out to be.
struct Reading {
  Conventions conventions;
  WrenchSign sign = WrenchSign::sensorOnPayload;  ///< Sign in the file
  /// Forces and torques in the stated sensor axes = turn * those that `conventions` yield. Not the unit matrix where
  /// the sensor is mounted another way than stated.
  Matrix3d turn = Matrix3d::Identity();
  Vector3d gravity{0.0, 0.0, -9.81};  ///< g_B [m/s2]
};

/// How a recording is to be understood as its setup file has it.
Reading statedIn(const RecordingMeta& meta);

/// What differs between two readings; the names are those of `frame_mistake.kind` in the contract.
enum class Change {
  wrenchSign,
  torqueSign,
  torqueFirst,
  axes,
  point,
  mirrored,
  turned,
  unit,
  gravitySign,
  gravityTurned,
  poseInverted,
  quaternionOrder
};
/// "wrench_sign", "torque_sign", "torque_first", "base_axes", "wrench_point", "mirrored", "turned", "unit",
/// "gravity_sign", "gravity_turned", "pose_inverted", "quaternion_order".
std::string_view toString(Change change);
std::vector<Change> changes(const Reading& from, const Reading& to);

/// What the file's numbers mean to `reading`, in words of a sentence each: "The force is given in the robot's base
/// axes, not in the sensor's axes." Only what differs from `stated`.
std::string sentence(const Reading& stated, const Reading& reading);
/// That what is stated does not fit, and that `likeliest` is one of several which do.
std::string tiedSentence(const Reading& stated, const Reading& likeliest);
/// Where in driver or controller to look.
std::string whatToCheck(const Reading& stated, const Reading& reading);

/// The meta of a recording that is understood as `reading` instead of `stated`; its mount is turned where the motion
/// comes from joints. Beside poses a turned sensor is no matter of the meta.
RecordingMeta metaSo(RecordingMeta meta, const Reading& stated, const Reading& reading, bool fromJoints);
/// The keys of a setup file that have to change, as a JSON merge patch; null where none does. `mount`: as stated.
nlohmann::json metaPatch(const Reading& stated, const Reading& reading, const SensorMount& mount, bool fromJoints);
/// The contract's keys of what `conventions` says that is not the plain form, and "wrench_sign".
nlohmann::json toJson(const Reading& reading);

/// Positions, orientations and what follows from them, where the file's poses mean `reading` instead of `stated`.
/// Nothing changes for joints. Twist that the file may report is not used.
void readPosesSo(const Reading& stated, const Reading& reading, Motion& motion);
/// The wrench of `motion`, and its specific force if gravity differs. The poses must have been read so before.
void readWrenchSo(const Reading& stated, const Reading& reading, Motion& motion);
/// Both: `motion` came from the file's numbers understood as `stated`; now it is as if they had been understood as
/// `reading`.
Motion readSo(Motion motion, const Reading& stated, const Reading& reading, bool posesInFile);

/// The file's numbers again [6 x K] from wrenches in plain form: the conventions put in, sign and turn left out.
MatrixXd asInFile(const Motion& motion, const Conventions& conventions);

}  // namespace heft::conventions
