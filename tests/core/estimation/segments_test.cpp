// What automatic segments do to an estimate.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/estimation/estimate.h"
#include "core/estimation/segment_recording.h"
#include "core/motion/accelerometer.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

Simulated simulated(MotionKind kind, std::uint64_t seed, Payload& payload, double rateHz = 500.0) {
  std::mt19937 random(static_cast<unsigned>(seed));
  SimulateOptions options;
  options.motion = kind;
  options.seed = seed;
  options.rateHz = rateHz;
  payload = test::randomTool(random).payload;
  return std::move(*simulate(RobotModel::panda(), payload, options));
}

TEST(Segments, AutomaticOnesCostLittleAgainstTrueOnes) {
  Eigen::Vector3d found = Eigen::Vector3d::Zero(), known = found;
  for (std::uint64_t seed = 41; seed <= 48; ++seed) {
    Payload truth;
    Simulated simulation = simulated(MotionKind::pickAndPlace, seed, truth);
    const auto squares = [&](const Recording& recording) {
      const auto report = estimate(recording, &RobotModel::panda(), {});
      const Payload& p = report->payload;
      return Eigen::Vector3d(std::pow(p.mass / truth.mass - 1.0, 2), (p.com - truth.com).squaredNorm(),
                             (p.inertiaCom - truth.inertiaCom).squaredNorm() / truth.inertiaCom.squaredNorm());
    };
    found += squares(simulation.recording);
    simulation.recording.meta.marks = simulation.truth.marks;
    known += squares(simulation.recording);
  }
  for (int i = 0; i < 3; ++i) EXPECT_LT(std::sqrt(found(i)), 1.5 * std::sqrt(known(i))) << i;
}

TEST(Segments, AnEstimateDoesNotMixTwoPayloads) {
  Payload truth;
  Simulated simulation = simulated(MotionKind::free, 51, truth);
  const double mass = 0.25;
  const Payload extra{mass, {0.0, 0.01, 0.14}, 1e-3 * mass * Matrix3d::Identity()};
  const auto motion = motionOf(simulation.recording, &RobotModel::panda(), {});
  const WrenchRows rows = rowsOf(*motion, 0.0);
  Recording& recording = simulation.recording;
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const double t = recording.time(i);
    if (t < 12.0) continue;
    const auto k = std::min<Eigen::Index>(rows.size() - 1, std::lround((t - rows.startTime) * rows.rateHz));
    recording.wrench.row(i) += (rows.Y[static_cast<std::size_t>(k)] * toParameters(extra)).transpose();
  }
  const auto report = estimate(recording, &RobotModel::panda(), {});
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->payload.mass, truth.mass, 0.01 * truth.mass);
  EXPECT_LT(report->usedDuration, 10.5);
  EXPECT_TRUE(std::any_of(report->findings.begin(), report->findings.end(),
                          [](const Finding& finding) { return finding.code == "payload_change"; }));
}

TEST(Segments, TheTrimIsLiftedOnlyWhereContactLeavesLittle) {
  Payload truth;
  Simulated simulation = simulated(MotionKind::free, 52, truth);
  Recording& recording = simulation.recording;
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    if (const double t = recording.time(i); t > 3.0 && t < 14.0)
      recording.wrench.row(i).head<3>() += Vector3d(3.0 + std::sin(3.0 * t), -2.0, 4.0 * std::cos(t)).transpose();
  EstimateOptions options;
  const auto lifted = estimate(recording, &RobotModel::panda(), options);
  options.keepTrim = true;
  const auto kept = estimate(recording, &RobotModel::panda(), options);
  ASSERT_TRUE(lifted && kept);
  EXPECT_GT(lifted->usedDuration, kept->usedDuration + 3.0);
  EXPECT_NEAR(lifted->payload.mass, truth.mass, 0.02 * truth.mass);
}

/// Evenly spaced rows of orientation and wrench, to be filled.
Recording roomForOrientation(Eigen::Index rows, double seconds) {
  Recording out;
  out.meta.gravity = {0.0, 0.0, -9.81};
  out.time = VectorXd::LinSpaced(rows, 0.0, seconds - seconds / static_cast<double>(rows));
  out.quaternion.resize(rows, 4);
  out.wrench.resize(rows, 6);
  return out;
}

TEST(Segments, OrientationAloneWithASwingIsUnderstood) {
  // A sensor that swings about a point 0.6 m away; without its position the centrifugal force would pass for payload.
  const Payload payload = test::boxPayload(0.9, {0.06, 0.06, 0.08}, {0.0, 0.0, 0.045});
  const Vector3d p_SoQ_S(0.0, 0.1, -0.6);
  constexpr Eigen::Index kRows = 4000;
  Recording recording = roomForOrientation(kRows, 8.0);
  const Vector3d gravity = recording.meta.gravity;
  std::mt19937 random(5);
  std::normal_distribution<double> noise;
  for (Eigen::Index i = 0; i < kRows; ++i) {
    const double w = 1.1, t = recording.time(i), angle = 1.6 * std::sin(w * t);
    const double rate = 1.6 * w * std::cos(w * t), second = -1.6 * w * w * std::sin(w * t);
    const Vector3d axis = Vector3d(1.0, 0.2, 0.0).normalized();
    const Matrix3d R = rotationFromVector(angle * axis);
    const Quaterniond q(R);
    recording.quaternion.row(i) << q.x(), q.y(), q.z(), q.w();
    const Vector3d omega = rate * axis, alpha = second * axis;
    const Vector3d a = -(alpha.cross(p_SoQ_S) + omega.cross(omega.cross(p_SoQ_S)));
    Vector6d wrench = predictWrench(payload, {a - R.transpose() * gravity, omega, alpha});
    for (int c = 0; c < 6; ++c) wrench(c) += (c < 3 ? 0.03 : 0.002) * noise(random);
    recording.wrench.row(i) = wrench.transpose();
  }
  const auto report = estimate(recording, nullptr, {});
  ASSERT_TRUE(report);
  EXPECT_TRUE(std::any_of(report->findings.begin(), report->findings.end(),
                          [](const Finding& finding) { return finding.code == "swing_assumed"; }));
  EXPECT_NEAR(report->payload.mass, 0.9, 0.01);
  EXPECT_LT((report->payload.com - payload.com).norm(), 0.003);
}

/// Orientation alone, of a sensor that is carried about, with an accelerometer that stands beside it and is turned.
TEST(Segments, AnAccelerometerBesideTheSensorGivesWhatTheOrientationLacks) {
  const Payload payload = test::boxPayload(0.9, {0.06, 0.06, 0.08}, {0.01, -0.005, 0.045});
  const Vector3d place(0.03, -0.02, 0.05);  // [m]
  const Matrix3d R_SI = rotationFromRpy({1.5, 0.1, -2.0});
  constexpr Eigen::Index kRows = 1200;
  Recording recording = roomForOrientation(kRows, 12.0);
  const Vector3d gravity = recording.meta.gravity;
  recording.accelerometer.resize(kRows, 3);
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  const auto turnAt = [](double t) {
    return rotationFromRpy({0.9 * std::sin(1.7 * t), 0.8 * std::sin(1.3 * t + 1.0), 0.6 * std::sin(2.1 * t)});
  };
  for (Eigen::Index i = 0; i < kRows; ++i) {
    constexpr double kStep = 1e-3;  // [s]
    const double t = recording.time(i);
    const Matrix3d R = turnAt(t), before = turnAt(t - kStep), after = turnAt(t + kStep);
    const auto rate = [&](const Matrix3d& from, const Matrix3d& to) -> Vector3d {
      const Eigen::AngleAxisd turn(Matrix3d(from.transpose() * to));
      return turn.angle() / kStep * turn.axis();
    };
    const Vector3d omega = 0.5 * (rate(before, R) + rate(R, after));
    const Vector3d alpha = (rate(R, after) - rate(before, R)) / kStep;
    const Vector3d a_B(1.5 * std::sin(5.0 * t), 2.0 * std::cos(3.7 * t), 1.0 * std::sin(6.3 * t));
    const Vector3d s = R.transpose() * (a_B - gravity);
    Quaterniond q(R);
    if (q.w() < 0.0) q.coeffs() = -q.coeffs();
    for (int c = 0; c < 4; ++c) recording.quaternion(i, c) = q.coeffs()(c) + 1e-4 * noise(random);
    Vector6d wrench = predictWrench(payload, {s, omega, alpha});
    for (int c = 0; c < 6; ++c) wrench(c) += (c < 3 ? 0.03 : 0.002) * noise(random);
    recording.wrench.row(i) = wrench.transpose();
    Vector3d felt = R_SI.transpose() * (s + leverMatrix(omega, alpha) * place);
    for (int c = 0; c < 3; ++c) felt(c) += 0.02 * noise(random);
    recording.accelerometer.row(i) = felt.transpose();
  }
  const auto with = estimate(recording, nullptr, {});
  ASSERT_TRUE(with);
  EXPECT_TRUE(std::any_of(with->findings.begin(), with->findings.end(),
                          [](const Finding& finding) { return finding.code == "accelerometer_used"; }));
  EXPECT_NE(with->trust, Trust::none);
  EXPECT_NEAR(with->payload.mass, 0.9, 0.01);
  EXPECT_LT((with->payload.com - payload.com).norm(), 0.003);
  recording.accelerometer.resize(0, 3);
  const auto without = estimate(recording, nullptr, {});
  ASSERT_TRUE(without);
  EXPECT_LT(with->heldoutForceRms, 0.5 * without->heldoutForceRms);
}

TEST(Segments, ARecordingThatIsAllContactStillHasSegments) {
  Payload truth;
  Simulated simulation = simulated(MotionKind::free, 53, truth, 250.0);
  simulation.recording.meta.marks = {{-1.0, 1e3, MarkLabel::contact}};
  const auto segmented = segmentRecording(simulation.recording, &RobotModel::panda(), {});
  ASSERT_TRUE(segmented);
  EXPECT_FALSE(segmented->usable);
  ASSERT_EQ(segmented->segmentation.segments.size(), 1u);
  const auto json = toJson(*segmented, simulation.recording);
  EXPECT_EQ(json["schema"], "heft.segment/1");
  EXPECT_NEAR(json["contact_s"].get<double>(), 20.0, 0.1);
  EXPECT_EQ(json["free_s"], 0.0);
  EXPECT_THAT(toText(*segmented, simulation.recording), testing::HasSubstr("Marked by you."));
}

TEST(Segments, AFirstEstimateIsReadFromAResult) {
  const nlohmann::json result{{"payload", toJson(test::boxPayload(0.5, {0.1, 0.1, 0.1}, {0, 0, 0.05}))},
                              {"std", {{"mass_kg", 0.01}, {"com_m", {0.001, 0.001, 0.002}}}}};
  const auto guess = payloadGuessFromJson(result, "result.json");
  ASSERT_TRUE(guess);
  EXPECT_EQ(guess->payload.mass, 0.5);
  EXPECT_EQ(guess->std.com.z(), 0.002);
  const auto wrong = payloadGuessFromJson(nlohmann::json{{"payload", 3}}, "result.json");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, testing::HasSubstr("result.json"));
}

}  // namespace
}  // namespace heft
