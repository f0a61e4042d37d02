#include "core/math/rigid.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace heft {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Rigid, SkewIsTheCrossProduct) {
  const Vector3d a(1, 2, 3), b(-4, 5, 0.5);
  EXPECT_TRUE((skew(a) * b).isApprox(a.cross(b)));
}

TEST(Rigid, RpyIsFixedAxisAsInUrdf) {
  // Yaw applied last, about the fixed z axis: x goes to y, whatever roll does about x first.
  EXPECT_TRUE((rotationFromRpy({0.3, 0.0, kPi / 2}) * Vector3d::UnitX()).isApprox(Vector3d::UnitY()));
  const Vector3d rpy(0.1, -0.4, 2.0);
  const Matrix3d expected =
      (Eigen::AngleAxisd(rpy(2), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy(1), Vector3d::UnitY()) *
       Eigen::AngleAxisd(rpy(0), Vector3d::UnitX()))
          .toRotationMatrix();
  EXPECT_TRUE(rotationFromRpy(rpy).isApprox(expected));
}

TEST(Rigid, RpyAndRotationVectorRoundTripAlsoAtThePoles) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (int i = 0; i < 200; ++i) {
    const Matrix3d R =
        rotationFromRpy({angle(random), i % 5 == 0 ? kPi / 2 * (i % 2 ? 1 : -1) : angle(random), angle(random)});
    EXPECT_LT((rotationFromRpy(rpyFromRotation(R)) - R).norm(), 1e-7) << i;
    EXPECT_LT((rotationFromVector(vectorFromRotation(R)) - R).norm(), 1e-9) << i;
  }
  EXPECT_LT((vectorFromRotation(rotationFromVector({1e-14, 0, 0})) - Vector3d(1e-14, 0, 0)).norm(), 1e-20);
}

}  // namespace
}  // namespace heft
