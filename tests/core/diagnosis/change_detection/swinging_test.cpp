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
    const auto* found = findParameter(report.causes.front().parameters, name);
    ASSERT_NE(found, nullptr) << name;
    EXPECT_NEAR(found->value, truth, 4.0 * found->std) << name;
  }
}

/// Moves from place to place, every third one cut short at its fastest by a stop of 80 ms.
class HardStops {
 public:
  explicit HardStops(RandomStream& random) : random_(random), from_(RobotModel::panda().homePosture()), way_(from_) {
    way_.setZero();
  }
  /// Asked for in the order of time.
  JointMotion operator()(double t) {
    while (t >= starts_ + kMove + kRest) {
      from_ = at(kMove).q;
      starts_ += kMove + kRest;
      cut_ = ++moves_ % 3 == 0 ? 0.5 : 1.0;
      for (Eigen::Index j = 0; j < 7; ++j)
        way_(j) = RobotModel::panda().homePosture()(j) + random_.uniform(-0.5, 0.5) - from_(j);
    }
    return at(t - starts_);
  }

 private:
  static constexpr double kMove = 1.2, kRest = 0.8, kStop = 0.08;  // [s]

  JointMotion at(double t) const {
    const double u = std::min(t / kMove, cut_), v = 1.0 - u;
    JointMotion out{from_ + u * u * u * (10.0 + u * (6.0 * u - 15.0)) * way_, 30.0 * u * u * v * v / kMove * way_,
                    60.0 * u * v * (1.0 - 2.0 * u) / (kMove * kMove) * way_};
    if (cut_ == 1.0 || t < cut_ * kMove) return out;
    const double s = std::min((t - cut_ * kMove) / kStop, 1.0), s3 = s * s * s;
    out.q += kStop * (s - s3 * s * (2.5 - s * (3.0 - s))) * out.dq;
    out.ddq = -30.0 * s * s * (1.0 - s) * (1.0 - s) / kStop * out.dq;
    out.dq *= 1.0 - s3 * (10.0 - s * (15.0 - 6.0 * s));
    return out;
  }

  RandomStream& random_;
  double starts_ = -kMove - kRest, cut_ = 1.0;  ///< The latter: of the move, where it is cut short
  int moves_ = 0;
  VectorXd from_, way_;
};

/// After a hard stop a motion that is smoothed differs from the true one by newtons: that is neither a touch nor noise
/// that comes and goes. What rings on afterwards, always at the same pitch, is the mount.
TEST(Diagnose, WhatRingsAfterAHardStopIsTheMount) {
  Payload tool = aTool();
  tool.mass = 1.6;
  for (const double frequency : {0.0, 16.0, 24.0})
    for (const std::uint64_t seed : {1, 2}) {
      RandomStream random(seed, RandomPurpose::effect);
      HardStops path(random);
      const auto report =
          diagnosed(along(path, tool, {1000.0, 4e-5, 0.0, 0.08, 0.0016}, random, Mount{frequency, 0.03}));
      if (frequency == 0.0) {
        EXPECT_EQ(report.verdict, Verdict::clean) << seed << ": " << said(report);
        continue;
      }
      const DiagnosedCause* mount = named(report, "flexible_mount");
      ASSERT_NE(mount, nullptr) << frequency << " Hz, " << seed << ": " << said(report);
      const CauseParameter* told = findParameter(mount->parameters, "frequency");
      EXPECT_NEAR(told->value, frequency, 3.0 * told->std) << seed;
      EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
    }
}

/// A motor with a rotor out of balance runs for two seconds, hard stops among them: it does not die away as a mount
/// does.
TEST(Diagnose, ARotorThatRunsForAWhileIsNoMount) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    RandomStream random(seed, RandomPurpose::effect);
    HardStops path(random);
    Recording recording = along(path, aTool(), {1000.0, 4e-6, 0.0, 0.02, 0.0016}, random, Mount{});
    for (Eigen::Index i = 0; i < recording.rows(); ++i) {
      const double t = recording.time(i), size = 0.4 * std::clamp(std::min(t - 5.8, 8.6 - t) / 0.3, 0.0, 1.0),
                   phase = 2.0 * std::numbers::pi * 14.7 * t;
      const Vector3d force(size * std::cos(phase), size * std::sin(phase), 0.0);
      recording.wrench.row(i).head<3>() += force.transpose();
      recording.wrench.row(i).tail<3>() += Vector3d(0.01, 0.02, 0.09).cross(force).transpose();
    }
    const auto report = diagnosed(recording);
    EXPECT_EQ(report.verdict, Verdict::unexplained) << seed << ": " << said(report);
    EXPECT_EQ(named(report, "flexible_mount"), nullptr) << seed << ": " << said(report);
  }
}

}  // namespace
}  // namespace heft::test
