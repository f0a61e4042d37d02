#pragma once
// What the causes are called in files and on the command line (CONTRACT.md). Only rules that are about one cause and no
// other name it so; what holds for several asks CauseInfo.
#include <string_view>

namespace heft::diagnosis::ids {

inline constexpr std::string_view sensorBias = "sensor_bias";
inline constexpr std::string_view biasDrift = "bias_drift";
inline constexpr std::string_view timeOffset = "time_offset";
inline constexpr std::string_view lowPassLag = "low_pass_lag";
inline constexpr std::string_view sensorRotation = "sensor_rotation";
inline constexpr std::string_view gravityTilt = "gravity_tilt";
inline constexpr std::string_view gainError = "gain_error";
inline constexpr std::string_view crosstalk = "crosstalk";
inline constexpr std::string_view cablePull = "cable_pull";
inline constexpr std::string_view viscousDrag = "viscous_drag";
inline constexpr std::string_view coulombFriction = "coulomb_friction";
inline constexpr std::string_view looseMass = "loose_mass";
inline constexpr std::string_view payloadChange = "payload_change";
inline constexpr std::string_view contact = "contact";
inline constexpr std::string_view jointOffset = "joint_offset";
inline constexpr std::string_view motionLag = "motion_lag";
inline constexpr std::string_view leverArm = "lever_arm";
inline constexpr std::string_view constantPull = "constant_pull";
inline constexpr std::string_view flexibleMount = "flexible_mount";
inline constexpr std::string_view derivativeNoise = "derivative_noise";
inline constexpr std::string_view hysteresis = "hysteresis";
inline constexpr std::string_view saturation = "saturation";
inline constexpr std::string_view spikes = "spikes";
inline constexpr std::string_view dropouts = "dropouts";
inline constexpr std::string_view jitter = "jitter";
inline constexpr std::string_view quantisation = "quantisation";
inline constexpr std::string_view frameError = "frame_error";
inline constexpr std::string_view wandering = "wandering";

}  // namespace heft::diagnosis::ids
