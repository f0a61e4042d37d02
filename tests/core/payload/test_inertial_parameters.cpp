#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/math/linear_algebra.h"
#include "core/payload/inertial_parameters.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

using test::randomPayload;
using testing::HasSubstr;

double difference(const Payload& a, const Payload& b) {
  return std::abs(a.mass - b.mass) + (a.com - b.com).norm() + (a.inertiaCom - b.inertiaCom).norm();
}

TEST(InertialParameters, OrderIsMassFirstMomentsThenUpperTriangleAboutTheOrigin) {
  Payload payload{2.0, {0.1, 0.2, 0.3}, Vector3d(0.01, 0.02, 0.025).asDiagonal()};
  payload.inertiaCom(0, 1) = payload.inertiaCom(1, 0) = -0.001;
  const Vector10d phi = toParameters(payload);
  EXPECT_DOUBLE_EQ(phi(0), 2.0);
  EXPECT_TRUE(phi.segment<3>(1).isApprox(Vector3d(0.2, 0.4, 0.6)));
  EXPECT_NEAR(phi(4), 0.01 + 2.0 * (0.04 + 0.09), 1e-15);  // Ixx = Icom + m (y2 + z2)
  EXPECT_NEAR(phi(5), -0.001 - 2.0 * 0.1 * 0.2, 1e-15);    // Ixy = Icom - m x y
  EXPECT_NEAR(phi(6), -2.0 * 0.1 * 0.3, 1e-15);
  EXPECT_NEAR(phi(7), 0.02 + 2.0 * (0.01 + 0.09), 1e-15);
  EXPECT_NEAR(phi(8), -2.0 * 0.2 * 0.3, 1e-15);
  EXPECT_NEAR(phi(9), 0.025 + 2.0 * (0.01 + 0.04), 1e-15);
}

TEST(InertialParameters, RoundTripsThroughParametersAndPseudoInertia) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const Payload payload = randomPayload(random);
    EXPECT_LT(difference(fromParameters(toParameters(payload)), payload), 1e-14);
    const Vector10d phi = toParameters(payload);
    EXPECT_LT((parametersFromPseudoInertia(pseudoInertia(phi)) - phi).norm(), 1e-15);
    EXPECT_GT(symmetricEigen(pseudoInertia(phi)).values(0), 0.0);
  }
}

TEST(InertialParameters, PointMassesHaveTheParallelAxisTermOnce) {
  const Payload point{1.5, {0.2, 0.0, 0.0}, Matrix3d::Zero()};
  EXPECT_TRUE(inertiaAboutOrigin(point).isApprox(Matrix3d(Vector3d(0.0, 0.06, 0.06).asDiagonal())));
}

TEST(InertialParameters, PhysicalMeansPositiveAndTriangle) {
  std::mt19937 random(2);
  EXPECT_TRUE(checkPhysical(randomPayload(random)).physical);
  EXPECT_TRUE(checkPhysical({1.0, Vector3d::Zero(), Vector3d(1.0, 2.0, 3.0).asDiagonal()}).physical) << "a flat plate";
  EXPECT_THAT(checkPhysical({-0.5, Vector3d::Zero(), Matrix3d::Identity()}).reason, HasSubstr("-0.5 kg"));
  EXPECT_THAT(checkPhysical({1.0, Vector3d::Zero(), Vector3d(1.0, 2.0, 3.1).asDiagonal()}).reason,
              HasSubstr("triangle"));
  EXPECT_THAT(checkPhysical({1.0, Vector3d::Zero(), Vector3d(-1.0, 2.0, 2.0).asDiagonal()}).reason,
              HasSubstr("principal moment"));
  EXPECT_FALSE(checkPhysical({std::nan(""), Vector3d::Zero(), Matrix3d::Identity()}).physical);
  Matrix3d skewed = Matrix3d::Identity();
  skewed(0, 1) = 0.1;
  EXPECT_THAT(checkPhysical({1.0, Vector3d::Zero(), skewed}).reason, HasSubstr("symmetric"));
}

TEST(InertialParameters, PhysicalAgreesWithThePseudoInertia) {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    Payload payload = randomPayload(random);
    payload.inertiaCom -= 0.3 * payload.inertiaCom.trace() * Matrix3d::Identity() * (i % 3 == 0 ? 1.0 : 0.0);
    const bool positive = symmetricEigen(pseudoInertia(toParameters(payload))).values(0) > 0.0;
    EXPECT_EQ(checkPhysical(payload).physical, positive) << "payload " << i;
  }
}

TEST(InertialParameters, FramesChangeThereAndBack) {
  std::mt19937 random(4);
  for (int i = 0; i < 50; ++i) {
    const Payload payload = randomPayload(random);
    Isometry3d X = Isometry3d::Identity();
    X.linear() = test::randomRotation(random);
    X.translation() = test::randomVector(random);
    const Payload moved = transformed(payload, X);
    EXPECT_LT(difference(transformed(moved, X.inverse()), payload), 1e-13);
    EXPECT_NEAR(moved.inertiaCom.trace(), payload.inertiaCom.trace(), 1e-14);
    // Composition does not care in which frame it happens.
    const Payload other = randomPayload(random);
    EXPECT_LT(difference(transformed(composed(payload, other), X), composed(moved, transformed(other, X))), 1e-13);
  }
}

TEST(InertialParameters, JsonRoundTripsBitByBit) {
  std::mt19937 random(5);
  const Payload payload = randomPayload(random);
  const auto read = payloadFromJson(nlohmann::json::parse(toJson(payload).dump()), "p.json");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->mass, payload.mass);
  EXPECT_EQ(read->com, payload.com);
  EXPECT_LT((read->inertiaCom - payload.inertiaCom).norm(), 1e-18);
  EXPECT_TRUE(payloadFromJson({{"payload", toJson(payload)}}, "estimate.json").ok());
}

TEST(InertialParameters, JsonDefectsNameTheKey) {
  const auto reason = [](const char* text) {
    const auto read = payloadFromJson(nlohmann::json::parse(text), "p.json");
    return read.ok() ? std::string() : read.error().message;
  };
  EXPECT_THAT(reason(R"({"mass_kg": -1})"), HasSubstr("mass_kg is -1"));
  EXPECT_THAT(reason(R"({"mass_kg": 1})"), HasSubstr("com_m is missing"));
  EXPECT_THAT(reason(R"({"mass_kg": 1, "com_m": [1, 2]})"), HasSubstr("com_m must be a list of 3"));
  EXPECT_THAT(reason(R"({"mass_kg": 1, "com_m": [1, 2, 3], "inertia_com_kgm2": [[1,0,0],[0.5,1,0],[0,0,1]]})"),
              HasSubstr("symmetric"));
  EXPECT_THAT(reason(R"([1])"), HasSubstr("must be a JSON object"));
}

}  // namespace
}  // namespace heft
