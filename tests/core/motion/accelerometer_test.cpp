// A simulated accelerometer of known mount beside a motion that is known exactly.
#include "core/motion/accelerometer.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/motion/motion.h"

namespace heft {
namespace {

const Vector3d kGravity(0.0, 0.0, -9.81);
const Vector3d kLever(0.04, -0.02, 0.07);  // [m]
const Vector3d kBias(0.12, -0.08, 0.05);   // [m/s2]
const Vector3d kMountRpy(0.4, -0.9, 2.1);  // [rad]
constexpr double kSensorNoise = 0.02;      // [m/s2]

Matrix3d rotationAt(double t) {
  return rotationFromVector({1.1 * std::sin(1.7 * t), 0.8 * std::sin(2.3 * t + 0.4), 0.9 * std::sin(1.3 * t + 1.0)});
}
Vector3d positionAt(double t, const Vector3d& p_S) {
  const Vector3d origin(0.4 + 0.1 * std::sin(5.0 * t), 0.08 * std::sin(4.1 * t), 0.5 + 0.06 * std::sin(6.3 * t));
  return origin + rotationAt(t) * p_S;
}
/// What an ideal accelerometer at p_S in the sensor feels, in S axes.
Vector3d feltAt(double t, const Vector3d& p_S) {
  constexpr double h = 1e-3;
  const Vector3d a = (positionAt(t + h, p_S) - 2.0 * positionAt(t, p_S) + positionAt(t - h, p_S)) / (h * h);
  return rotationAt(t).transpose() * (a - kGravity);
}

/// 12 s at 200 Hz with the readings of the accelerometer and of a gyroscope beside it.
Recording recorded(bool positions, bool gyroscope, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, kSensorNoise);
  const Matrix3d R_SI = rotationFromRpy(kMountRpy);
  constexpr Eigen::Index kRows = 2400;
  Recording out;
  out.meta.gravity = kGravity;
  out.time.resize(kRows);
  out.quaternion.resize(kRows, 4);
  if (positions) out.position.resize(kRows, 3);
  out.accelerometer.resize(kRows, 3);
  if (gyroscope) out.gyroscope.resize(kRows, 3);
  out.wrench.setZero(kRows, 6);
  for (Eigen::Index k = 0; k < kRows; ++k) {
    const double t = 0.005 * static_cast<double>(k), h = 1e-4;
    out.time(k) = t;
    out.quaternion.row(k) = Quaterniond(rotationAt(t)).coeffs().transpose();
    if (positions) out.position.row(k) = positionAt(t, Vector3d::Zero()).transpose();
    const Vector3d felt = R_SI.transpose() * feltAt(t, kLever) + kBias;
    const Vector3d turning = vectorFromRotation(rotationAt(t - h).transpose() * rotationAt(t + h)) / (2.0 * h);
    for (int c = 0; c < 3; ++c) out.accelerometer(k, c) = felt(c) + noise(random);
    if (gyroscope) out.gyroscope.row(k) = (R_SI.transpose() * turning).transpose();
  }
  return out;
}

double degreesBetween(const Matrix3d& a, const Matrix3d& b) {
  return vectorFromRotation(a.transpose() * b).norm() * 57.29578;
}

bool says(const Motion& motion, const char* code) {
  return std::ranges::any_of(motion.findings, [&](const Finding& finding) { return finding.code == code; });
}

/// Deviation of the specific force from the truth at `p_S`, away from the ends [m/s2].
double errorAt(const Motion& motion, const Vector3d& p_S) {
  double squares = 0.0;
  Eigen::Index count = 0;
  for (Eigen::Index k = motion.size() / 10; k < 9 * motion.size() / 10; ++k, ++count)
    squares += (motion.specificForce.col(k) - feltAt(motion.time(k), p_S)).squaredNorm() / 3.0;
  return std::sqrt(squares / static_cast<double>(count));
}

TEST(Accelerometer, StandsInForTheAccelerationThatOrientationLacks) {
  for (const bool gyroscope : {false, true}) {
    Recording recording = recorded(false, gyroscope, 1);
    const auto heard = motionOf(recording, nullptr, {});
    ASSERT_TRUE(heard.ok());
    ASSERT_TRUE(heard->accelerometer);
    EXPECT_TRUE(heard->originAccelerationKnown);
    EXPECT_TRUE(says(*heard, "accelerometer_used"));
    EXPECT_FALSE(says(*heard, "origin_acceleration_unknown"));
    EXPECT_LT(degreesBetween(heard->accelerometer->R_SI, rotationFromRpy(kMountRpy)), gyroscope ? 0.2 : 2.0);
    recording.accelerometer.resize(0, 3);
    const auto deaf = motionOf(recording, nullptr, {});
    ASSERT_TRUE(deaf.ok());
    // Its own place is not told by a motion without positions, so it is measured there.
    EXPECT_LT(errorAt(*heard, kLever), 0.25 * errorAt(*deaf, kLever));
  }
}

/// The force follows what the accelerometer feels, wherever the tool's centre is; one of the opposite sign is no help
/// and does no harm.
TEST(Accelerometer, TheForceTellsHowItIsTurned) {
  const Matrix3d R_SI = rotationFromRpy(kMountRpy);
  const Vector3d com(0.02, 0.01, -0.06);  // [m]
  const auto without = motionOf(recorded(false, false, 3), nullptr, {});
  for (const double sign : {1.0, -1.0}) {
    Recording recording = recorded(false, false, 3);
    std::mt19937 random(4);
    std::normal_distribution<double> noise(0.0, 0.05);
    for (Eigen::Index k = 0; k < recording.rows(); ++k) {
      const Vector3d force = sign * 1.3 * feltAt(recording.time(k), com) + Vector3d(4.0, -2.0, 7.0);
      for (int c = 0; c < 3; ++c) recording.wrench(k, c) = force(c) + noise(random);
    }
    const auto motion = motionOf(recording, nullptr, {});
    ASSERT_TRUE(motion.ok() && motion->accelerometer && without.ok() && without->accelerometer);
    if (sign > 0.0) {
      EXPECT_LT(degreesBetween(motion->accelerometer->R_SI, R_SI), 0.2);
      EXPECT_GT(degreesBetween(without->accelerometer->R_SI, R_SI), 0.5);
      EXPECT_GT(motion->accelerometer->explained, 0.95);
    } else {
      EXPECT_LT(degreesBetween(motion->accelerometer->R_SI, without->accelerometer->R_SI), 1e-6);
    }
  }
}

TEST(Accelerometer, OneThatReportsGravityIsTurned) {
  for (const bool positions : {false, true})
    for (const bool gyroscope : {false, true}) {
      Recording recording = recorded(positions, gyroscope, 5);
      const auto usual = motionOf(recording, nullptr, {});
      recording.accelerometer *= -1.0;
      const auto turned = motionOf(recording, nullptr, {});
      ASSERT_TRUE(usual.ok() && turned.ok());
      EXPECT_FALSE(says(*usual, "accelerometer_gravity"));
      EXPECT_TRUE(says(*turned, "accelerometer_gravity"));
      EXPECT_TRUE(says(*turned, positions ? "accelerometer_agrees" : "accelerometer_used"));
      EXPECT_NEAR((turned->specificForce - usual->specificForce).norm(), 0.0, 1e-9 * usual->specificForce.norm());
    }
}

TEST(Accelerometer, ItsWholeMountIsFoundWhereTheMotionIsKnown) {
  const Recording recording = recorded(true, false, 2);
  const auto motion = motionOf(recording, nullptr, {});
  ASSERT_TRUE(motion.ok());
  EXPECT_TRUE(says(*motion, "accelerometer_agrees"));
  Eigen::Matrix3Xd readings(3, motion->size()), s(3, motion->size());
  for (Eigen::Index k = 0; k < motion->size(); ++k) {
    readings.col(k) = rotationFromRpy(kMountRpy).transpose() * feltAt(motion->time(k), kLever) + kBias;
    s.col(k) = feltAt(motion->time(k), Vector3d::Zero());
  }
  const Eigen::Matrix3Xd none(3, 0);
  const auto mount = mountOf({readings, s, motion->omega, motion->alpha, none, none}, true);
  ASSERT_TRUE(mount);
  EXPECT_LT(degreesBetween(mount->R_SI, rotationFromRpy(kMountRpy)), 0.1);
  EXPECT_LT((mount->p_SoI_S - kLever).norm(), 0.003);
  EXPECT_LT((mount->bias - kBias).norm(), 0.03);
}

TEST(Accelerometer, AnotherBodysReadingsAreNotUsed) {
  Recording recording = recorded(false, false, 3);
  // Bolted to the table: gravity never turns.
  for (Eigen::Index k = 0; k < recording.rows(); ++k) recording.accelerometer.row(k) << 0.1, 0.0, 9.8;
  const auto motion = motionOf(recording, nullptr, {});
  ASSERT_TRUE(motion.ok());
  EXPECT_FALSE(motion->accelerometer);
  EXPECT_FALSE(motion->originAccelerationKnown);
  EXPECT_TRUE(says(*motion, "accelerometer_unused"));
}

TEST(Accelerometer, ContradictsAMotionThatTheToolDidNotMake) {
  Recording recording = recorded(true, false, 4);
  // The tool shakes on a mount that gives way; neither joints nor poses know of it.
  for (Eigen::Index k = 0; k < recording.rows(); ++k)
    recording.accelerometer(k, 0) += 3.0 * std::sin(60.0 * recording.time(k));
  const auto motion = motionOf(recording, nullptr, {});
  ASSERT_TRUE(motion.ok());
  EXPECT_TRUE(says(*motion, "accelerometer_disagrees"));
}

}  // namespace
}  // namespace heft
