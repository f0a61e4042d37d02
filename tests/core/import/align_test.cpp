// Offsets between clocks, found where they are known.
#include "core/import/align.h"

#include <fmt/format.h>

#include <numbers>
#include <random>

#include "core/motion/motion.h"
#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;

/// Specific force of a wandering orientation at 100 Hz.
Eigen::Matrix3Xd wandering(Eigen::Index count) {
  Eigen::Matrix3Xd out(3, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double t = 0.01 * static_cast<double>(k);
    const double roll = std::sin(0.7 * t) + 0.6 * std::sin(0.31 * t + 1.0);
    const double pitch = 0.8 * std::sin(0.43 * t + 0.5) + 0.3 * std::sin(1.7 * t);
    out.col(k) = 9.81 * Vector3d(std::sin(pitch), std::cos(pitch) * std::sin(roll), std::cos(pitch) * std::cos(roll));
  }
  return out;
}

TEST(Offset, IsFoundWithNoiseAnyMountingAndBias) {
  const auto motion = wandering(4000);
  const Matrix3d R = rotationFromRpy({0.3, -1.0, 2.0});
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.3);
  for (const double truth : {-7.123, 0.0, 3.456}) {
    const Eigen::Index rows = 15000;  // 30 s at 500 Hz
    VectorXd time(rows);
    Eigen::MatrixX3d force(rows, 3);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const double onMotionClock = 4.0 + 0.002 * static_cast<double>(k);
      time(k) = onMotionClock - truth;
      const auto i = static_cast<Eigen::Index>(onMotionClock * 100.0);
      const double share = onMotionClock * 100.0 - static_cast<double>(i);
      const Vector3d s = (1.0 - share) * motion.col(i) + share * motion.col(i + 1);
      force.row(k) = (0.8 * (R * s) + Vector3d(4.0, -3.0, 1.0)).transpose();
      for (int a = 0; a < 3; ++a) force(k, a) += noise(random);
    }
    const auto found = findOffset(motion, 0.0, 100.0, time, force, -15.0, 15.0);
    EXPECT_TRUE(found.sure);
    EXPECT_NEAR(found.seconds, truth, 0.01);
    EXPECT_GT(found.explained, 0.9);
  }
}

/// The force of a tool of 0.8 kg on that motion, `truth` seconds late, over 16 s.
OffsetEstimate foundFor(const Eigen::Matrix3Xd& motion, double truth, double noiseSize) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, noiseSize);
  VectorXd time(1600);
  Eigen::MatrixX3d force(1600, 3);
  for (Eigen::Index k = 0; k < 1600; ++k) {
    time(k) = 2.0 + 0.01 * static_cast<double>(k) - truth;
    force.row(k) = 0.8 * motion.col(200 + k).transpose();
    for (int a = 0; a < 3; ++a) force(k, a) += noise(random);
  }
  return findOffset(motion, 0.0, 100.0, time, force, -10.0, 10.0);
}

TEST(Offset, IsFoundWhereSlowTiltingLooksAlikeElsewhere) {
  Eigen::Matrix3Xd slow(3, 2000);
  for (Eigen::Index k = 0; k < 2000; ++k) {
    const double t = 0.01 * static_cast<double>(k);
    const double roll = 0.4 * std::sin(0.25 * t) + 0.03 * std::sin(1.9 * t), pitch = 0.3 * std::sin(0.33 * t + 0.5);
    slow.col(k) = 9.81 * Vector3d(std::sin(pitch), std::cos(pitch) * std::sin(roll), std::cos(pitch) * std::cos(roll));
  }
  const auto found = foundFor(slow, 1.5, 0.05);
  EXPECT_GT(found.runnerUp, 0.9);
  EXPECT_TRUE(found.sure);
  EXPECT_NEAR(found.seconds, 1.5, 0.02);
}

/// A centre far from the sensor, turned quickly: what accelerates it beside the sensor belongs to the force.
TEST(Offset, IsFinerWithWhatTheLeverDoes) {
  const Eigen::Index count = 2000;
  MatrixXd motion(12, count);
  motion.topRows<3>() = wandering(count);
  for (Eigen::Index k = 0; k < count; ++k)
    for (int row = 3; row < 12; ++row)
      motion(row, k) = 8.0 * std::sin((1.1 + 0.37 * row) * 0.01 * static_cast<double>(k) + row);
  constexpr double kTruth = 0.1234;  // [s]
  VectorXd time(1600);
  Eigen::MatrixX3d force(1600, 3);
  for (Eigen::Index k = 0; k < 1600; ++k) {
    time(k) = 2.0 + 0.01 * static_cast<double>(k) - kTruth;
    const VectorXd x = motion.col(200 + k);
    force.row(k) = (0.8 * x.head<3>() + 0.1 * (x.segment<3>(3) + x.segment<3>(6) - x.tail<3>())).transpose();
  }
  const auto plain = findOffset(motion.topRows<3>(), 0.0, 100.0, time, force, -5.0, 5.0);
  const auto fine = findOffset(motion, 0.0, 100.0, time, force, -5.0, 5.0);
  EXPECT_NEAR(fine.seconds, kTruth, 0.0005);
  EXPECT_LT(fine.std, 0.001);
  EXPECT_GT(std::abs(plain.seconds - kTruth), 0.002);
}

TEST(Offset, IsUnsureWhereTheMotionRepeatsItself) {
  Eigen::Matrix3Xd same(3, 2000);
  for (Eigen::Index k = 0; k < 2000; ++k) {
    const double phase = 2.0 * std::numbers::pi * 0.01 * static_cast<double>(k) / 4.0;
    same.col(k) = 9.81 * Vector3d(0.3 * std::sin(phase), 0.3 * std::cos(2.0 * phase), 0.9 + 0.05 * std::sin(phase));
  }
  EXPECT_FALSE(foundFor(same, 1.5, 0.05).sure);
}

TEST(Offset, IsUnsureWhereTheForceKnowsNothingOfTheMotion) {
  const auto motion = wandering(3000);
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 1.0);
  VectorXd time = VectorXd::LinSpaced(3000, 0.0, 29.99);
  Eigen::MatrixX3d force(3000, 3);
  for (Eigen::Index k = 0; k < 3000; ++k)
    for (int a = 0; a < 3; ++a) force(k, a) = noise(random);
  EXPECT_FALSE(findOffset(motion, 0.0, 100.0, time, force, -10.0, 10.0).sure);
}

TEST(Average, IsExactForLinearValues) {
  VectorXd time(5);
  time << 0.0, 0.1, 0.25, 0.3, 0.5;
  MatrixXd values(5, 1);
  values.col(0) = 3.0 * time.array() - 1.0;
  VectorXd at(3);
  at << 0.0, 0.2, 0.45;
  for (const double width : {0.0, 0.15}) {
    const MatrixXd out = averageAt(time, values, at, width);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(out(i, 0), 3.0 * at(i) - 1.0, 1e-12);
  }
}

using Clocks = InFolder;

TEST_F(Clocks, OfALibfrankaLogAndAWrenchFileAreBroughtTogether) {
  // A log whose clock starts at 100 s, and a wrench that Newton makes of it on a clock of its own.
  Recording recording;
  recording.meta.robot = "panda";
  const Eigen::Index rows = 2500;
  recording.time = VectorXd::LinSpaced(rows, 100.0, 100.0 + 0.01 * static_cast<double>(rows - 1));
  recording.q.resize(rows, 7);
  recording.wrench.setZero(rows, 6);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const double t = 0.01 * static_cast<double>(k);
    for (int j = 0; j < 7; ++j)
      recording.q(k, j) =
          jointAt(0.0, j) + 0.35 * std::sin((0.4 + 0.13 * j) * t + j) + 0.2 * std::sin((0.9 + 0.07 * j) * t);
  }
  MotionOptions options;
  options.outputRateHz = 100.0;
  const auto motion = motionOf(recording, &RobotModel::panda(), options);
  ASSERT_TRUE(motion.ok());
  std::string log = "time,success_rate";
  for (int j = 0; j < 7; ++j) log += fmt::format(",state.q[{}]", j);
  log += "\n";
  for (Eigen::Index k = 0; k < rows; ++k) {
    log += fmt::format("{},1", 100000 + 10 * k);
    for (int j = 0; j < 7; ++j) log += fmt::format(",{:.9f}", recording.q(k, j));
    log += "\n";
  }
  std::string wrench = "time,fx,fy,fz,tx,ty,tz\n";
  for (Eigen::Index k = 0; k < motion->size(); ++k) {
    const Vector3d f = 1.2 * motion->specificForce.col(k) + Vector3d(2.0, 1.0, -3.0);
    const Vector3d tau = Vector3d(0.0, 0.0, 0.06).cross(f);
    wrench += fmt::format("{:.4f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", motion->time(k) - 98.5, f.x(), f.y(),
                          f.z(), tau.x(), tau.y(), tau.z());
  }
  ImportOptions importOptions;
  importOptions.join = {write("wrench.csv", wrench)};
  const auto read = openRecording(write("log.csv", log), importOptions);
  ASSERT_TRUE(read.ok()) << read.error().message;
  ASSERT_TRUE(hasCode(read->findings, "clock_offset")) << allTexts(read->findings);
  // Its first force stands where the motion has it.
  const Eigen::Index middle = read->recording.rows() / 2;
  const auto k =
      static_cast<Eigen::Index>(std::lround((read->recording.time(middle) - motion->startTime) * motion->rateHz));
  const Vector3d expected = 1.2 * motion->specificForce.col(k) + Vector3d(2.0, 1.0, -3.0);
  EXPECT_NEAR((read->recording.wrench.row(middle).head<3>().transpose() - expected).norm(), 0.0, 0.1);
}

}  // namespace
}  // namespace heft
