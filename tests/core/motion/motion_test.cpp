#include "core/motion/motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace heft {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

/// Joint motion with exact derivatives.
struct JointMotion {
  static VectorXd at(double t, int derivative) {
    VectorXd out(7);
    for (int j = 0; j < 7; ++j) {
      const double w = 2 * kHalfTurn * (0.15 + 0.06 * j);
      const double amplitude = 0.3, phase = w * t + j + derivative * kHalfTurn / 2;
      out(j) = amplitude * std::pow(w, derivative) * std::sin(phase) +
               (derivative == 0 ? RobotModel::panda().homePosture()(j) : 0.0);
    }
    return out;
  }
};

Recording jointRecording(double rate, double seconds, bool withVelocity) {
  Recording recording;
  const auto n = static_cast<Eigen::Index>(rate * seconds) + 1;
  recording.meta.robot = "panda";
  recording.meta.mount = {"panda_link8", {0.01, -0.02, 0.05}, {0.2, -0.3, 0.4}};
  recording.time.resize(n);
  recording.q.resize(n, 7);
  if (withVelocity) recording.dq.resize(n, 7);
  recording.wrench.setZero(n, 6);
  for (Eigen::Index k = 0; k < n; ++k) {
    recording.time(k) = static_cast<double>(k) / rate;
    recording.q.row(k) = JointMotion::at(recording.time(k), 0).transpose();
    if (withVelocity) recording.dq.row(k) = JointMotion::at(recording.time(k), 1).transpose();
  }
  return recording;
}

/// The same motion as poses of S.
Recording poseRecording(double rate, double seconds, bool withPosition) {
  Recording recording = jointRecording(rate, seconds, false);
  const RobotModel& panda = RobotModel::panda();
  const int link = *panda.findLink("panda_link8");
  const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  recording.quaternion.resize(recording.rows(), 4);
  if (withPosition) recording.position.resize(recording.rows(), 3);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    const Isometry3d X = panda.linkPose(recording.q.row(k).transpose(), link) * X_LS;
    const Quaterniond q(X.linear());
    // A sign that flips at random is how many drivers write quaternions.
    recording.quaternion.row(k) = (k % 7 == 3 ? -1.0 : 1.0) * q.coeffs().transpose();
    if (withPosition) recording.position.row(k) = X.translation().transpose();
  }
  recording.q.resize(0, 0);
  return recording;
}

void expectTrueMotion(const Motion& motion, double tolerance) {
  const RobotModel& panda = RobotModel::panda();
  const int link = *panda.findLink("panda_link8");
  const Isometry3d X_LS = poseFromXyzRpy({0.01, -0.02, 0.05}, {0.2, -0.3, 0.4});
  const Vector3d g(0, 0, -9.81);
  double worst = 0.0;
  for (Eigen::Index k = motion.size() / 10; k < motion.size() * 9 / 10; ++k) {
    const double t = motion.time(k);
    const FrameMotion truth =
        panda.frameMotion(link, X_LS, JointMotion::at(t, 0), JointMotion::at(t, 1), JointMotion::at(t, 2));
    const Matrix3d R = truth.X_BS.linear().transpose();
    worst =
        std::max({worst, (motion.specificForce.col(k) - R * (truth.a_BSo_B - g)).norm(),
                  (motion.omega.col(k) - R * truth.w_BS_B).norm(), (motion.alpha.col(k) - R * truth.alpha_BS_B).norm(),
                  (motion.velocity.col(k) - truth.v_BSo_B).norm()});
  }
  EXPECT_LT(worst, tolerance);
}

TEST(Motion, JointsGiveTheTrueMotionWithAndWithoutVelocities) {
  for (const bool withVelocity : {false, true}) {
    const auto motion = motionOf(jointRecording(1000.0, 6.0, withVelocity), &RobotModel::panda(), {});
    ASSERT_TRUE(motion.ok());
    EXPECT_NEAR(motion->rateHz, 200.0, 1e-6);
    expectTrueMotion(*motion, 0.01);
  }
}

TEST(Motion, PosesGiveTheSameMotionAsJoints) {
  const auto motion = motionOf(poseRecording(1000.0, 6.0, true), nullptr, {});
  ASSERT_TRUE(motion.ok());
  expectTrueMotion(*motion, 0.01);
}

TEST(Motion, SlowRecordingsKeepTheirAccuracy) {
  const auto motion = motionOf(poseRecording(100.0, 6.0, true), nullptr, {});
  ASSERT_TRUE(motion.ok());
  EXPECT_NEAR(motion->rateHz, 100.0, 1e-6);
  expectTrueMotion(*motion, 0.01);
}

TEST(Motion, SavitzkyGolayGivesItToo) {
  MotionOptions options;
  options.smoothing = SmoothingKind::savitzkyGolay;
  options.window = 10;
  const auto motion = motionOf(jointRecording(1000.0, 6.0, true), &RobotModel::panda(), options);
  ASSERT_TRUE(motion.ok());
  expectTrueMotion(*motion, 0.01);
}

/// A turn to and fro at 7 Hz, smoothed at 10 Hz: the filter takes 1 / (1 + (f/fc)^-12), twicing the square of that.
TEST(Motion, TwicingGivesBackWhatTheFilterTakes) {
  constexpr double kRate = 1000.0, kHz = 7.0, kCutoff = 10.0, kTurn = 0.02;
  Recording recording;
  recording.meta.robot = "panda";
  recording.time.setLinSpaced(4001, 0.0, 4.0);
  recording.wrench.setZero(4001, 6);
  recording.quaternion.setZero(4001, 4);
  for (Eigen::Index k = 0; k <= 4000; ++k) {
    const double half = 0.5 * kTurn * std::sin(2.0 * kHalfTurn * kHz * static_cast<double>(k) / kRate);
    recording.quaternion.row(k) << 0.0, 0.0, std::sin(half), std::cos(half);
  }
  const double taken = 1.0 - 1.0 / (1.0 + std::pow(kHz / kCutoff, 12));
  for (const bool twicing : {false, true}) {
    MotionOptions options;
    options.cutoffHz = kCutoff;
    options.twicing = twicing;
    const auto motion = motionOf(recording, nullptr, options);
    ASSERT_TRUE(motion.ok());
    double largest = 0.0;
    for (Eigen::Index k = motion->size() / 4; k < motion->size() * 3 / 4; ++k)
      largest = std::max(largest, std::abs(motion->alpha(2, k)));
    const double left = largest / (kTurn * std::pow(2.0 * kHalfTurn * kHz, 2));
    // Averages over an output interval of 5 ms, and peaks between two of them, take 0.4 % themselves.
    EXPECT_NEAR(1.0 - left, (twicing ? taken * taken : taken) + 0.002, 0.0025) << twicing;
  }
}

TEST(Motion, JitteringTimeDoesNotHarm) {
  Recording recording = jointRecording(500.0, 6.0, false);
  for (Eigen::Index k = 1; k + 1 < recording.rows(); ++k) {
    recording.time(k) += 0.0005 * std::sin(static_cast<double>(k) * 12.9898);
    recording.q.row(k) = JointMotion::at(recording.time(k), 0).transpose();
  }
  const auto motion = motionOf(recording, &RobotModel::panda(), {});
  ASSERT_TRUE(motion.ok());
  expectTrueMotion(*motion, 0.05);
}

TEST(Motion, OrientationAloneTakesTheOriginAsUnaccelerated) {
  const auto motion = motionOf(poseRecording(1000.0, 6.0, false), nullptr, {});
  ASSERT_TRUE(motion.ok());
  EXPECT_FALSE(motion->originAccelerationKnown);
  for (Eigen::Index k = 0; k < motion->size(); ++k) EXPECT_NEAR(motion->specificForce.col(k).norm(), 9.81, 1e-9);
  EXPECT_EQ(motion->findings.back().code, "origin_acceleration_unknown");
}

TEST(Motion, LateVelocitiesAreNotTrusted) {
  Recording recording = jointRecording(1000.0, 6.0, true);
  for (Eigen::Index k = 0; k < recording.rows(); ++k)
    recording.dq.row(k) = JointMotion::at(recording.time(k) - 0.03, 1).transpose();
  for (Eigen::Index k = 0; k < recording.rows(); ++k)  // noisy positions, so that velocities would be preferred
    recording.q.row(k).array() += 2e-5 * std::sin(static_cast<double>(k) * 78.233);
  const auto motion = motionOf(recording, &RobotModel::panda(), {});
  ASSERT_TRUE(motion.ok());
  ASSERT_FALSE(motion->findings.empty());
  EXPECT_EQ(motion->findings[0].code, "velocity_lag");
  EXPECT_THAT(motion->findings[0].text, testing::HasSubstr("30 ms"));
  expectTrueMotion(*motion, 0.3);
}

TEST(Motion, TheWrenchIsAveragedWithoutShift) {
  Recording recording = jointRecording(1000.0, 4.0, false);
  for (Eigen::Index k = 0; k < recording.rows(); ++k)
    for (int c = 0; c < 6; ++c) recording.wrench(k, c) = std::sin(2 * kHalfTurn * 1.0 * recording.time(k) + c);
  const auto motion = motionOf(recording, &RobotModel::panda(), {});
  ASSERT_TRUE(motion.ok());
  for (Eigen::Index k = 0; k < motion->size(); ++k)
    EXPECT_NEAR(motion->wrench(2, k), std::sin(2 * kHalfTurn * 1.0 * motion->time(k) + 2), 2e-4);
}

TEST(Motion, StandingPosesAreGravityAlone) {
  Recording recording = jointRecording(1.0, 8.0, false);
  recording.meta.kind = RecordingKind::poses;
  const auto motion = standingPoses(recording, &RobotModel::panda());
  ASSERT_TRUE(motion.ok());
  EXPECT_EQ(motion->size(), recording.rows());
  EXPECT_EQ(motion->omega.norm(), 0.0);
  const RobotModel& panda = RobotModel::panda();
  const Matrix3d R = (panda.linkPose(recording.q.row(3).transpose(), *panda.findLink("panda_link8")) *
                      poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy))
                         .linear();
  EXPECT_LT((motion->specificForce.col(3) - R.transpose() * Vector3d(0, 0, 9.81)).norm(), 1e-12);
}

TEST(Motion, SaysWhatIsMissing) {
  Recording recording = jointRecording(1000.0, 1.0, false);
  const auto without = motionOf(recording, nullptr, {});
  ASSERT_FALSE(without.ok());
  EXPECT_THAT(without.error().message, testing::HasSubstr("no robot"));
  recording.meta.mount.parent = "tool0";
  const auto unknown = motionOf(recording, &RobotModel::panda(), {});
  ASSERT_FALSE(unknown.ok());
  EXPECT_THAT(unknown.error().message, testing::AllOf(testing::HasSubstr("tool0"), testing::HasSubstr("panda_link8")));
  EXPECT_FALSE(motionOf(jointRecording(1000.0, 0.005, false), &RobotModel::panda(), {}).ok());
}

TEST(Motion, SaysWhereAClockLeaptByAnHour) {
  Recording recording = jointRecording(1000.0, 1.0, false);
  recording.time.tail(recording.rows() - 400).array() += 3600.0;
  const auto motion = motionOf(recording, &RobotModel::panda(), {});
  ASSERT_FALSE(motion.ok());
  EXPECT_THAT(motion.error().message, testing::HasSubstr("between row 400 at 0.399 s and the next at 3600.400 s"));
}

}  // namespace
}  // namespace heft
