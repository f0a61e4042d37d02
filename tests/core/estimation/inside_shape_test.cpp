// All mass held inside the picked shape.
#include "core/estimation/inside_shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/payload/shape_bound.h"
#include "tests/support/estimation_fixtures.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

using test::has;
using test::recordingOf;
using test::reportOf;

Eigen::Matrix3Xd pointsOf(const char* text) {
  const auto shape = parseShape(text);
  Findings findings;
  return boundPoints(*shape, *sampleShape(*shape, findings));
}

TEST(ShapeBound, PointsReachTheCornersAndStayInside) {
  const Eigen::Matrix3Xd box = pointsOf("box:0.2,0.4,0.6@0,0,1");
  EXPECT_NEAR(box.row(0).maxCoeff(), 0.1, 1e-12);
  EXPECT_NEAR(box.row(1).minCoeff(), -0.2, 1e-12);
  EXPECT_NEAR(box.row(2).maxCoeff(), 1.3, 1e-12);
  for (const char* text : {"cylinder:0.1,0.4", "tube:0.1,0.05,0.4", "cone:0.1,0.4", "capsule:0.1,0.2", "sphere:0.1"}) {
    const Eigen::Matrix3Xd points = pointsOf(text);
    EXPECT_NEAR(points.row(0).maxCoeff(), 0.1, 0.003) << text;
    EXPECT_LE(points.topRows<2>().colwise().norm().maxCoeff(), 0.1 + 1e-9) << text;
    EXPECT_GT(points.row(2).maxCoeff() - points.row(2).minCoeff(), 0.195) << text;
  }
}

TEST(ShapeCone, PayloadsInsideStayAndThoseOutsideComeIn) {
  const ShapeCone cone(pointsOf("box:0.08,0.10,0.12@0.01,0,0.06"));
  Matrix10d root = Matrix10d::Identity();
  root.diagonal().tail<6>().setConstant(1e3);
  const Vector10d inside = toParameters(test::boxPayload(0.8, {0.08, 0.10, 0.12}, {0.01, 0.0, 0.06}));
  EXPECT_LT((root * (cone.nearest(root, inside) - inside)).norm(), 1e-7);
  const Vector10d outside = toParameters(test::boxPayload(0.8, {0.08, 0.10, 0.12}, {0.01, 0.0, 0.30}));
  const Payload moved = fromParameters(cone.nearest(root, outside));
  EXPECT_LE(moved.com.z(), 0.12 + 1e-9) << "no mass lies above the box";
}

TEST(InsideShape, TheBoundHoldsForTheEstimateAndItsIntervals) {
  const Payload truth = test::boxPayload(0.8, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06});
  const Recording recording = recordingOf(MotionKind::free, truth, 41, 0.3);
  EstimateOptions options;
  options.shape = *parseShape("box:0.08,0.10,0.12@0.01,-0.005,0.06");
  const auto soft = reportOf(recording, options);
  options.insideShape = true;
  const auto right = reportOf(recording, options);
  EXPECT_TRUE(has(right, "held_inside_shape"));
  EXPECT_LT((right.payload.com - soft.payload.com).norm(), 2e-4) << "the true shape does not pull";
  EXPECT_NEAR(right.payload.mass, soft.payload.mass, 2.0 * soft.std.mass);

  // A box of half the size about the true centre: no distribution inside it has the true inertia.
  options.shape = *parseShape("box:0.04,0.05,0.06@0.01,-0.005,0.06");
  const auto small = reportOf(recording, options);
  EXPECT_TRUE(small.physicallyConsistent);
  const double m = small.payload.mass;
  const double largest = m * (0.020 * 0.020 + 0.025 * 0.025);  // all mass in the corners
  EXPECT_LE(small.payload.inertiaCom(2, 2), largest * (1.0 + 1e-6));
  EXPECT_LE(small.interval95.inertiaCom[2][2].upper, 1.1 * largest);
  EXPECT_THAT(toText(small), testing::HasSubstr("keeping it inside shifted the result"));
  options.insideShape = false;
  EXPECT_GT(reportOf(recording, options).payload.inertiaCom(2, 2), largest);
}

TEST(InsideShape, NeedsAShapeAndMap) {
  const Recording recording =
      recordingOf(MotionKind::free, test::boxPayload(0.8, {0.08, 0.10, 0.12}, {0, 0, 0.06}), 42);
  EstimateOptions options;
  options.insideShape = true;
  EXPECT_THAT(estimate(recording, &RobotModel::panda(), options).error().message, testing::HasSubstr("needs a shape"));
}

}  // namespace
}  // namespace heft
