// An accelerometer in a file of its own, beside a sensor's orientation and wrench.
#include <fmt/format.h>

#include "core/recording/conventions.h"
#include "fixtures.h"

namespace heft {
namespace {

using namespace testing_support;

constexpr double kEpochStart = 1.7e9;  // [s]
constexpr double kLate = 0.008;        // [s] The accelerometer's stamps are early by so much.
constexpr double kMass = 1.5;          // [kg]

double tiltAt(double t) { return 0.7 * std::sin(2.1 * t); }

/// What the tool feels [m/s2], turning about x, with a shake of its own that no orientation tells.
Vector3d feltAt(double t) {
  return {2.0 * std::sin(11.0 * t), 9.81 * std::sin(tiltAt(t)) + 1.5 * std::sin(17.0 * t), 9.81 * std::cos(tiltAt(t))};
}

class WitnessFiles : public InFolder {
 protected:
  /// `zero`: of the accelerometer's clock [s].
  ImportOptions files(double zero, const std::string& names, int from = 0) const {
    std::string orientation = "t,qx,qy,qz,qw\n", wrench = "t,fx,fy,fz,tx,ty,tz\n", felt = names + "\n";
    const auto micros = [](double t) { return std::llround(1e6 * t); };
    for (int k = 0; k <= 1000; ++k) {
      const double t = 0.01 * k;
      orientation += fmt::format("{},{:.9g},0,0,{:.9g}\n", micros(kEpochStart + t), std::sin(0.5 * tiltAt(t)),
                                 std::cos(0.5 * tiltAt(t)));
    }
    for (int k = 0; k <= 5000; ++k) {
      const double t = 0.002 * k;
      const Vector3d f = kMass * feltAt(t);
      wrench += fmt::format("{},{:.9g},{:.9g},{:.9g},0.1,0.2,0.3\n", micros(kEpochStart + t), f.x(), f.y(), f.z());
    }
    for (int k = from; k <= 2500; ++k) {
      const double t = 0.004 * k;
      const Vector3d a = feltAt(t + kLate) / kStandardGravity;
      felt += fmt::format("{},{:.9g},{:.9g},{:.9g}\n", micros(zero + t), a.y(), a.z(), a.x());
    }
    write("orientation.csv", orientation);
    ImportOptions options;
    options.join = {write("wrench.csv", wrench), write("felt.csv", felt)};
    return options;
  }
};

TEST_F(WitnessFiles, AnAccelerometerInGIsShiftedToTheForceAndJoined) {
  for (const std::string names :
       {"t,ax,ay,az", "t,imu_acc_x,imu_acc_y,imu_acc_z",
        "t,actual_tool_accelerometer_0,actual_tool_accelerometer_1,actual_tool_accelerometer_2"}) {
    const auto options = files(kEpochStart, names);
    const auto read = openRecording(folder_ / "orientation.csv", options);
    ASSERT_TRUE(read.ok()) << names << ": " << read.error().message;
    EXPECT_TRUE(hasCode(read->findings, "accelerometer_in_g")) << allTexts(read->findings);
    EXPECT_TRUE(hasCode(read->findings, "accelerometer_shifted")) << allTexts(read->findings);
    const auto& recording = read->recording;
    ASSERT_EQ(recording.accelerometer.rows(), recording.rows()) << names;
    // Averaged over 10 ms, which takes 1 mm/s2 of the fastest part, and shifted to within a quarter of a millisecond.
    for (Eigen::Index k = 5; k + 5 < recording.rows(); ++k) {
      const Vector3d felt = feltAt(recording.time(k));
      EXPECT_NEAR(recording.accelerometer(k, 0), felt.y(), 0.03);
      EXPECT_NEAR(recording.accelerometer(k, 1), felt.z(), 0.03);
      EXPECT_NEAR(recording.accelerometer(k, 2), felt.x(), 0.03);
    }
  }
}

TEST_F(WitnessFiles, OnAnotherClockItIsLeftAside) {
  const auto read = openRecording(folder_ / "orientation.csv", files(0.0, "t,ax,ay,az"));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_FALSE(read->recording.hasAccelerometer());
  EXPECT_TRUE(hasCode(read->findings, "accelerometer_unused")) << allTexts(read->findings);
}

TEST(WitnessCandidates, ImuMessagesGiveBothUnlessTheyRideElsewhere) {
  std::vector<Stream> streams(2);
  for (auto& stream : streams) {
    stream.type = "sensor_msgs/Imu";
    stream.fields = {"orientation.x",
                     "orientation.y",
                     "orientation.z",
                     "orientation.w",
                     "angular_velocity.x",
                     "angular_velocity.y",
                     "angular_velocity.z",
                     "linear_acceleration.x",
                     "linear_acceleration.y",
                     "linear_acceleration.z",
                     "linear_acceleration_covariance[0]"};
  }
  streams[0].name = "/camera/imu";
  streams[1].name = "/tool/imu";
  int camera = 0, tool = 0;
  for (const auto& candidate : findCandidates(streams, {})) {
    if (candidate.part != "accelerometer" && candidate.part != "gyroscope") continue;
    EXPECT_EQ(candidate.columns.size(), 3u);
    EXPECT_EQ(candidate.score < 0, candidate.columns[0].stream == 0) << candidate.part;
    (candidate.columns[0].stream == 0 ? camera : tool)++;
  }
  EXPECT_EQ(camera, 2);
  EXPECT_EQ(tool, 2);
}

/// One that begins late is worth the rows before it where nothing else tells the acceleration, if they are not most.
TEST_F(WitnessFiles, WhatBeginsLateShortensTheRecording) {
  const auto late = files(kEpochStart, "t,ax,ay,az", 700);  // 2.8 of 10 s
  const auto read = openRecording(folder_ / "orientation.csv", late);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_TRUE(hasCode(read->findings, "accelerometer_span")) << allTexts(read->findings);
  ASSERT_TRUE(read->recording.hasAccelerometer()) << allTexts(read->findings);
  EXPECT_NEAR(read->recording.duration(), 7.2, 0.03);
  const auto later = openRecording(folder_ / "orientation.csv", files(kEpochStart, "t,ax,ay,az", 1500));  // 6 of 10 s
  ASSERT_TRUE(later.ok()) << later.error().message;
  EXPECT_FALSE(later->recording.hasAccelerometer());
  EXPECT_NEAR(later->recording.duration(), 10.0, 0.03);
}

}  // namespace
}  // namespace heft
