// What heft diagnose says of standing poses.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/report/report.h"
#include "core/diagnosis/wording/words.h"
#include "core/motion/motion.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

constexpr double kPoseRad = std::numbers::pi / 180.0;

/// What is hidden in the poses.
struct InPoses {
  Vector3d turn = Vector3d::Zero();        ///< Of the sensor [rad]
  Vector3d gravity{0.0, 0.0, -9.81};       ///< As it is [m/s2]
  Vector3d pull = Vector3d::Zero();        ///< At the sensor's origin, base axes [N]
  double stiffness = 0.0;                  ///< Of a cable from the base's origin [N/m]
  Matrix6d sensor = Matrix6d::Identity();  ///< Gains and crosstalk
  Vector6d drift = Vector6d::Zero();       ///< From pose to pose
  Vector6d jump = Vector6d::Zero();        ///< From the middle on
  int joint = -1;                          ///< Whose zero is off
  double offset = 0.0;                     ///< By so much [rad]
  std::vector<int> touched;                ///< Poses with 3 N along x
};

/// A Panda stands still in `count` random postures.
Recording standingWith(int count, unsigned seed, const InPoses& hidden = {}) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const RobotModel& robot = RobotModel::panda();
  Recording out;
  out.meta.robot = "panda";
  out.meta.kind = RecordingKind::poses;
  const int link = *robot.findLink(out.meta.mount.parent);
  const Isometry3d X_LS = poseFromXyzRpy(out.meta.mount.xyz, out.meta.mount.rpy);
  const Payload tool = aTool();
  Vector6d zero;
  zero << 3.0, -2.0, 5.0, 0.1, -0.2, 0.05;
  out.time = VectorXd::LinSpaced(count, 0.0, 5.0 * (count - 1));
  out.q.resize(count, 7);
  out.wrench.resize(count, 6);
  for (int k = 0; k < count; ++k) {
    VectorXd q(7);
    q << uniform(random), -0.3 + 0.7 * uniform(random), uniform(random), -1.8 + 0.6 * uniform(random),
        1.5 * uniform(random), 1.8 + 1.3 * uniform(random), 2.0 * uniform(random);
    out.q.row(k) = q.transpose();
    if (hidden.joint >= 0) q(hidden.joint) += hidden.offset;
    const Isometry3d X = robot.linkPose(q, link) * X_LS;
    const Matrix3d back = X.linear().transpose();
    Vector6d w = predictWrench(tool, {back * -hidden.gravity, Vector3d::Zero(), Vector3d::Zero()});
    w.head<3>() -= back * (hidden.pull - hidden.stiffness * X.translation());  // The sensor holds it
    const Matrix3d turn = rotationFromVector(hidden.turn).transpose();
    w.head<3>() = (turn * w.head<3>()).eval();
    w.tail<3>() = (turn * w.tail<3>()).eval();
    w = hidden.sensor * w + zero + k * hidden.drift;
    if (2 * k >= count) w += hidden.jump;
    if (std::ranges::find(hidden.touched, k) != hidden.touched.end()) w(0) += 3.0;
    for (int c = 0; c < 6; ++c) w(c) += (c < 3 ? 0.03 : 0.0015) * normal(random);
    out.wrench.row(k) = w.transpose();
  }
  return out;
}

std::string withNumbers(const DiagnosisReport& report) {
  std::string out(toString(report.verdict));
  for (const auto& cause : report.causes) {
    out += fmt::format("\n  {} {:.0f} ({})", cause.id, cause.deltaBic, fmt::join(cause.alternatives, ", "));
    for (const auto& p : cause.parameters) out += fmt::format(" {} {:.4g} +- {:.2g}", p.name, p.value, 1.96 * p.std);
  }
  return out;
}

TEST(Poses, CleanOnesHaveNoCause) {
  for (const int count : {24, 60, 100})
    for (unsigned seed = 1; seed <= (count == 24 ? 60u : 20u); ++seed) {
      const auto report = diagnosed(standingWith(count, 100 * seed + static_cast<unsigned>(count)));
      EXPECT_EQ(report.verdict, Verdict::clean) << count << " poses, seed " << seed << ": " << withNumbers(report);
      EXPECT_FALSE(report.mistake);
    }
}

struct PoseCase {
  const char* cause;
  InPoses hidden;
  std::vector<std::pair<const char*, double>> values;
};

std::vector<PoseCase> poseCases() {
  std::vector<PoseCase> out;
  InPoses hidden;
  hidden.turn = Vector3d(2.0, -1.5, 2.5) * kPoseRad;
  out.push_back({"sensor_rotation", hidden, {{"rx", 2.0}, {"ry", -1.5}, {"rz", 2.5}}});
  hidden = {};
  hidden.gravity = rotationFromVector(Vector3d(2.0, -1.5, 0.0) * kPoseRad) * hidden.gravity;
  out.push_back({"gravity_tilt", hidden, {{"tilt_x", 2.0}, {"tilt_y", -1.5}}});
  hidden = {};
  hidden.sensor(0, 0) = 1.05;
  out.push_back({"gain_error", hidden, {{"gain_fx", 5.0}}});
  hidden = {};
  hidden.sensor(1, 2) = 0.05;
  out.push_back({"crosstalk", hidden, {{"fz_to_fy", 5.0}}});
  hidden = {};
  hidden.drift << 0.02, -0.02, 0.03, 0.0, 0.001, 0.0;
  out.push_back({"bias_drift", hidden, {{"fx", 0.02}, {"fz", 0.03}, {"ty", 0.001}}});
  hidden = {};
  hidden.jump << 0.3, 0.0, -0.4, 0.0, 0.01, 0.0;
  out.push_back({"sensor_bias", hidden, {{"fx", 0.3}, {"fz", -0.4}}});
  hidden = {};
  hidden.pull = Vector3d(1.0, -0.8, 0.0);
  out.push_back({"constant_pull", hidden, {{"force_x", 1.0}, {"force_y", -0.8}}});
  hidden = {};
  hidden.stiffness = 3.0;
  out.push_back({"cable_pull", hidden, {{"stiffness", 3.0}}});
  hidden = {};
  hidden.joint = 3;
  hidden.offset = 2.0 * kPoseRad;
  out.push_back({"joint_offset", hidden, {{"q4_offset", 2.0}}});
  return out;
}

/// Each cause by itself: named first, or told among the ties, with its size in the interval.
TEST(Poses, EachCauseIsNamedWithItsSize) {
  int values = 0, inside = 0;
  for (const PoseCase& one : poseCases())
    for (const int count : {24, 60}) {
      int right = 0;
      constexpr unsigned kSeeds = 6;
      std::string last;
      for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        const auto report = diagnosed(standingWith(count, 7000 + 31 * seed, one.hidden));
        last = withNumbers(report);
        if (report.causes.empty() || report.mistake) continue;
        const DiagnosedCause& first = report.causes.front();
        const bool tied = std::ranges::find(first.alternatives, one.cause) != first.alternatives.end();
        right += first.id == one.cause || tied ? 1 : 0;
        EXPECT_NEAR(report.after.payload.mass, aTool().mass, std::max(0.03, 1.96 * report.after.std.mass))
            << one.cause << ": " << last;
        if (first.id != one.cause) continue;
        for (const auto& [name, value] : one.values)
          if (const CauseParameter* p = findParameter(first.parameters, name)) {
            ++values;
            inside += std::abs(p->value - value) <= 1.96 * p->std ? 1 : 0;
          }
      }
      EXPECT_GE(right, static_cast<int>(kSeeds) - 1) << one.cause << ", " << count << " poses: " << last;
    }
  EXPECT_GE(inside, 0.88 * values) << inside << " of " << values;
  EXPECT_GE(values, 100);
}

TEST(Poses, BadOnesAreListed) {
  InPoses hidden;
  hidden.touched = {4, 17};
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto report = diagnosed(standingWith(24, seed, hidden));
    const DiagnosedCause* touched = named(report, "contact");
    ASSERT_NE(touched, nullptr) << withNumbers(report);
    EXPECT_EQ(report.causes.size(), 1u) << withNumbers(report);
    EXPECT_NE(touched->sentence.find("5, 18"), std::string::npos) << touched->sentence;
    EXPECT_NEAR(report.after.payload.mass, aTool().mass, 0.01);
  }
}

TEST(Poses, ConventionsAreToldAndPutRight) {
  Recording recording = standingWith(24, 3);
  const auto motion = standingPoses(recording, &RobotModel::panda()).value();
  for (int k = 0; k < 24; ++k) {
    const Matrix3d& R = motion.R_BS[static_cast<std::size_t>(k)];
    const Vector6d w = recording.wrench.row(k).transpose();
    recording.wrench.row(k) << (R * w.head<3>()).transpose(), (R * w.tail<3>()).transpose();
  }
  const auto report = diagnosed(recording);
  ASSERT_TRUE(report.mistake) << withNumbers(report);
  EXPECT_TRUE(report.mistake->has(conventions::Change::axes)) << report.mistake->sentence();
  EXPECT_EQ(report.metaChanges()["sensor"]["wrench_axes"], "base");
  EXPECT_NEAR(report.after.payload.mass, aTool().mass, 0.02);
  EXPECT_EQ(toJson(report)["frame_mistake"]["kind"], "base_axes");
  const auto put = corrected(recording, &RobotModel::panda(), toJson(report), {"frame_error"});
  ASSERT_TRUE(put.ok());
  EXPECT_LT((put->wrench - standingWith(24, 3).wrench).cwiseAbs().maxCoeff(), 1e-9);
}

// Standing poses cannot tell units apart: the report says so, proposes no setup file, and has the right one among those
// that fit.
TEST(Poses, UnitsAreATie) {
  Recording recording = standingWith(24, 3);
  recording.wrench.leftCols<3>() /= 9.80665;     // kgf
  recording.wrench.rightCols<3>() /= 0.0980665;  // kgf cm
  const auto report = diagnosed(recording);
  ASSERT_TRUE(report.mistake) << withNumbers(report);
  EXPECT_TRUE(report.mistake->tied);
  EXPECT_EQ(report.verdict, Verdict::ambiguous);
  EXPECT_NE(report.sentence.find("cannot show which ones do"), std::string::npos) << report.sentence;
  EXPECT_TRUE(report.metaChanges().empty());
  EXPECT_TRUE(std::ranges::any_of(report.mistake->ties, [](const conventions::Alternative& tie) {
    return std::abs(tie.payload.mass - aTool().mass) < 0.02;
  }));
}

TEST(Poses, TooFewAreRefused) { EXPECT_FALSE(diagnose(standingWith(5, 1), &RobotModel::panda(), {}).ok()); }

}  // namespace
}  // namespace heft::test
