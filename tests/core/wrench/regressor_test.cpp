#include "core/wrench/regressor.h"

#include <gtest/gtest.h>

#include "core/wrench/rows.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

using test::randomPayload;
using test::randomRotation;
using test::randomVector;

TEST(Regressor, TimesParametersIsTheWrenchComputedDirectly) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const Payload payload = randomPayload(random);
    const WrenchState state{randomVector(random, 12.0), randomVector(random, 3.0), randomVector(random, 20.0)};
    const Vector6d direct = predictWrench(payload, state);
    EXPECT_LT((regressor(state) * toParameters(payload) - direct).norm(), 1e-12 * direct.norm());
  }
}

TEST(Regressor, StandingStillIsWeightAtTheCentreOfMass) {
  // Tool pointing down (S's z down): the sensor pulls the payload up, against gravity, with its weight.
  const Payload payload{0.8, {0.01, -0.02, 0.05}, 1e-3 * Matrix3d::Identity()};
  const Matrix3d R_BS = rotationFromRpy({M_PI, 0, 0});
  const Vector3d g(0, 0, -9.81);
  const Vector6d F = predictWrench(payload, {R_BS.transpose() * (-g), Vector3d::Zero(), Vector3d::Zero()});
  EXPECT_TRUE((R_BS * F.head<3>()).isApprox(Vector3d(0, 0, 0.8 * 9.81), 1e-12));
  EXPECT_TRUE(F.tail<3>().isApprox(payload.com.cross(Vector3d(F.head<3>())), 1e-12));
}

TEST(Regressor, TiltedToolTellsTheRotationFromItsTranspose) {
  const Payload payload{1.0, {0, 0, 0.1}, 1e-3 * Matrix3d::Identity()};
  const Matrix3d R_BS = rotationFromRpy({0.4, 0.0, 0.9});
  const Vector3d up(0, 0, 9.81);
  const Vector6d right = predictWrench(payload, {R_BS.transpose() * up, Vector3d::Zero(), Vector3d::Zero()});
  const Vector6d wrong = predictWrench(payload, {R_BS * up, Vector3d::Zero(), Vector3d::Zero()});
  EXPECT_GT((right - wrong).norm(), 1.0);
  EXPECT_LT((R_BS * right.head<3>() - up).norm(), 1e-12);
}

/// Momentum and angular momentum about a base point, differentiated numerically: Newton and Euler without any formula
/// for accelerating frames.
TEST(Regressor, EqualsTheRateOfMomentumOfAMovingBody) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const Payload payload = randomPayload(random);
    const Matrix3d R0 = randomRotation(random);
    const Vector3d w1 = randomVector(random), w2 = randomVector(random), p1 = randomVector(random),
                   p2 = randomVector(random, 4.0);
    const Vector3d g(0.3, -0.2, -9.81);
    const auto rotation = [&](double t) -> Matrix3d { return rotationFromVector(w1 * t + w2 * t * t) * R0; };
    const auto origin = [&](double t) -> Vector3d { return p1 * t + 0.5 * p2 * t * t; };
    const double h = 1e-4;
    const auto omega = [&](double t) -> Vector3d {  // base axes, from the rotation itself
      return vectorFromRotation(rotation(t + h) * rotation(t - h).transpose()) / (2 * h);
    };
    const auto momentum = [&](double t) -> Vector3d {
      const auto com = [&](double s) -> Vector3d { return origin(s) + rotation(s) * payload.com; };
      return payload.mass * (com(t + h) - com(t - h)) / (2 * h);
    };
    const auto angular = [&](double t) -> Vector3d {  // about the centre of mass
      return rotation(t) * payload.inertiaCom * rotation(t).transpose() * omega(t);
    };
    const double d = 1e-3;
    const Vector3d force = (momentum(d) - momentum(-d)) / (2 * d) - payload.mass * g;
    const Vector3d torqueCom = (angular(d) - angular(-d)) / (2 * d);
    const Matrix3d R = rotation(0.0);
    Vector6d expected;
    expected << R.transpose() * force, R.transpose() * torqueCom + payload.com.cross(Vector3d(R.transpose() * force));
    const Vector3d alpha = (omega(d) - omega(-d)) / (2 * d);
    const WrenchState state{R.transpose() * (p2 - g), R.transpose() * omega(0.0), R.transpose() * alpha};
    const Vector6d actual = predictWrench(payload, state);
    EXPECT_LT((actual - expected).norm(), 2e-4 * (1.0 + expected.norm()))
        << "expected " << expected.transpose() << "\nactual " << actual.transpose();
  }
}

TEST(Rows, AveragesRegressorAndWrenchAlike) {
  std::mt19937 random(3);
  const Payload payload = randomPayload(random);
  Motion motion;
  motion.rateHz = 200.0;
  motion.specificForce = motion.omega = motion.alpha = Eigen::Matrix3Xd::Random(3, 10) * 5.0;
  motion.wrench.resize(6, 10);
  for (int k = 0; k < 10; ++k)
    motion.wrench.col(k) =
        predictWrench(payload, {motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)});
  const WrenchRows rows = rowsOf(motion, 50.0);
  ASSERT_EQ(rows.size(), 2);
  EXPECT_DOUBLE_EQ(rows.rateHz, 50.0);
  EXPECT_DOUBLE_EQ(rows.time(0), 1.5 / 200.0);
  for (int k = 0; k < 2; ++k)
    EXPECT_LT((rows.Y[static_cast<std::size_t>(k)] * toParameters(payload) - rows.wrench.col(k)).norm(), 1e-12);
}

}  // namespace
}  // namespace heft
