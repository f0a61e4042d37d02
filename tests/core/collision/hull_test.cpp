#include "core/collision/hull.h"

#include <gtest/gtest.h>

#include <random>

namespace heft {
namespace {

Eigen::Matrix3Xd randomPoints(int count, unsigned seed, const Vector3d& size) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::Matrix3Xd out(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    out.col(i) = size.cwiseProduct(Vector3d{normal(random), normal(random), normal(random)});
  return out;
}

TEST(ConvexHull, HoldsItsPointsAndHasTheVolumeOfACube) {
  Eigen::Matrix3Xd cube(3, 9);
  for (int i = 0; i < 8; ++i) cube.col(i) = Vector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  cube.col(8) = Vector3d::Constant(0.5);
  const auto hull = convexHull(cube);
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->vertices.cols(), 8);
  EXPECT_EQ(hull->triangles.size(), 12u);
  double volume = 0.0;
  for (const auto& t : hull->triangles)
    volume += hull->vertices.col(t[0]).dot(hull->vertices.col(t[1]).cross(hull->vertices.col(t[2]))) / 6.0;
  EXPECT_NEAR(volume, 1.0, 1e-12) << "triangles run counter-clockwise seen from outside";
  EXPECT_TRUE(hull->contains({0.5, 0.5, 0.5}));
  EXPECT_FALSE(hull->contains({0.5, 0.5, 1.01}));

  const Eigen::Matrix3Xd cloud = randomPoints(500, 3, {1.0, 0.2, 3.0});
  const auto around = convexHull(cloud);
  ASSERT_TRUE(around);
  for (Eigen::Index i = 0; i < cloud.cols(); ++i)
    EXPECT_LE((around->faces.topRows<3>().transpose() * cloud.col(i) + around->faces.row(3).transpose()).maxCoeff(),
              1e-9);
}

TEST(ConvexHull, FlatThinAndSinglePointsGetAThickness) {
  for (const Vector3d& size : {Vector3d(1.0, 1.0, 0.0), Vector3d(0.0, 1.0, 0.0), Vector3d(0.0, 0.0, 0.0)}) {
    const auto hull = convexHull(randomPoints(40, 4, size));
    ASSERT_TRUE(hull) << size.transpose();
    EXPECT_GE(hull->triangles.size(), 4u);
    EXPECT_LT((hull->vertices.rowwise().maxCoeff() - hull->vertices.rowwise().minCoeff()).minCoeff(), 0.001);
  }
  EXPECT_FALSE(convexHull(Eigen::Matrix3Xd(3, 0)));
}

}  // namespace
}  // namespace heft
