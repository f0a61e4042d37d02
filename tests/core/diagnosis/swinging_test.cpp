// Parts of the tool that swing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/motion.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

/// Two halves swing against each other, so that what swings takes no weight along: its force acts where it sits. It was
/// two loose parts and a pull.
TEST(Swinging, APartWhoseWeightStaysInPlace) {
  constexpr double kMass = 0.35, kFrequency = 2.3, kDamping = 0.08;
  const Vector3d seat(0.02, -0.015, 0.08);
  Recording recording = aRecording(MotionKind::excitation, 651);
  MotionOptions smoothing;
  smoothing.cutoffHz = 25.0;
  const auto motion = motionOf(recording, &RobotModel::panda(), smoothing).value();
  const double w = 2.0 * std::numbers::pi * kFrequency, dt = 1.0 / motion.rateHz;
  Vector3d x = -motion.specificForce.col(0) / (w * w), v = Vector3d::Zero();
  std::vector<Vector3d> pulls;
  const auto pullAt = [&](Eigen::Index k) -> Vector3d {
    const Vector3d o = motion.omega.col(k), alpha = motion.alpha.col(k);
    return motion.specificForce.col(k) + alpha.cross(seat) + o.cross(o.cross(seat));
  };
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    pulls.push_back(kMass * (-pullAt(k) - 2.0 * kDamping * w * v - w * w * x));
    if (k + 1 == motion.size()) break;
    const Vector3d o = motion.omega.col(k), alpha = motion.alpha.col(k);
    constexpr int kSteps = 20;
    for (int i = 0; i < kSteps; ++i) {
      const Vector3d pull = pullAt(k) + (i + 0.5) / kSteps * (pullAt(k + 1) - pullAt(k)),
                     turning = 2.0 * o.cross(v) + alpha.cross(x) + o.cross(o.cross(x));
      v += dt / kSteps * (-pull - turning - 2.0 * kDamping * w * v - w * w * x);
      x += dt / kSteps * v;
    }
  }
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const double at = std::clamp((recording.time(i) - motion.startTime) * motion.rateHz, 0.0,
                                 static_cast<double>(motion.size() - 2) + 0.999);
    const auto k = static_cast<std::size_t>(at);
    const Vector3d f = pulls[k] + (at - static_cast<double>(k)) * (pulls[k + 1] - pulls[k]);
    recording.wrench.row(i).head<3>() += f.transpose();
    recording.wrench.row(i).tail<3>() += seat.cross(f).transpose();
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "loose_mass") << said(report);
  for (const auto& [name, truth] : {std::pair{"mass", 1e3 * kMass}, {"frequency", kFrequency}, {"damping", kDamping}}) {
    const auto* found = parameter(report.causes.front(), name);
    ASSERT_NE(found, nullptr) << name;
    EXPECT_NEAR(found->value, truth, 4.0 * found->std) << name;
  }
}

}  // namespace
}  // namespace heft::test
