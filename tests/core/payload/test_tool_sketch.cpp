#include <gtest/gtest.h>

#include "core/payload/tool_sketch.h"

namespace heft {
namespace {

TEST(ToolSketch, EveryPictureIsAValidShapeThatBeginsAtTheSensor) {
  for (const ToolPicture picture : kToolPictures) {
    EXPECT_EQ(toolPictureFromString(toString(picture)), picture);
    Shape shape;
    shape.bodies = sketch(picture);
    if (picture == ToolPicture::mesh) {
      EXPECT_TRUE(shape.bodies.empty());
      continue;
    }
    EXPECT_EQ(whyInvalid(shape), "") << toString(picture);
    const auto box = extentOf(shape);
    EXPECT_NEAR(box.min().z(), 0, 1e-12) << toString(picture);
    EXPECT_NEAR(box.center().x(), 0, 1e-12);
    EXPECT_NEAR(box.center().y(), 0, 1e-12);
    Findings findings;
    EXPECT_TRUE(sampleShape(shape, findings).ok());
    if (bodyKindOf(picture)) {
      EXPECT_EQ(pictureOf(shape), picture);
    }
  }
  EXPECT_FALSE(toolPictureFromString("spoon"));
}

TEST(ToolSketch, SizesAreKeptWhenThePictureChanges) {
  const Vector3d size(0.050, 0.050, 0.200);
  for (const ToolPicture picture : {ToolPicture::box, ToolPicture::cylinder, ToolPicture::tube, ToolPicture::cone,
                                    ToolPicture::capsule, ToolPicture::gripper}) {
    Shape shape;
    shape.bodies = sketch(picture, size);
    EXPECT_NEAR((extentOf(shape).sizes() - size).norm(), 0, 1e-9) << toString(picture);
  }
}

TEST(ToolSketch, MeasuresAreWhatARulerShows) {
  ShapeBody capsule = sketch(ToolPicture::capsule, Vector3d(0.04, 0.04, 0.1)).front();
  auto measures = measuresOf(capsule);
  ASSERT_EQ(measures.size(), 2u);
  EXPECT_NEAR(measures[0].value, 0.04, 1e-12);
  EXPECT_NEAR(measures[1].value, 0.10, 1e-12);
  // A wider capsule is no longer one.
  capsule = resized(capsule, 0, 0.06, 0);
  EXPECT_NEAR(measuresOf(capsule)[1].value, 0.10, 1e-12);
  EXPECT_NEAR(capsule.dims[0], 0.03, 1e-12);
  EXPECT_NEAR(capsule.dims[1], 0.04, 1e-12);
  // Until its caps do not fit: then it is a ball.
  capsule = resized(capsule, 0, 0.12, 0);
  EXPECT_NEAR(measuresOf(capsule)[1].value, 0.12, 1e-12);
  EXPECT_EQ(capsule.dims[1], 0.0);
}

TEST(ToolSketch, TheSideThatIsHeldStaysWhereItIs) {
  for (const ToolPicture picture : kToolPictures) {
    const auto kind = bodyKindOf(picture);
    if (!kind) continue;
    ShapeBody body = sketch(picture).front();
    body.X_SB = poseFromXyzRpy({0.01, -0.02, 0.03}, {0.4, 0.2, -0.7}) * body.X_SB;
    const auto measures = measuresOf(body);
    for (std::size_t m = 0; m < measures.size(); ++m) {
      const int axis = measures[m].axis;
      if (axis < 0) continue;
      for (const int hold : {-1, 0, 1}) {
        const ShapeBody larger = resized(body, m, measures[m].value + 0.011, hold);
        EXPECT_NEAR(measuresOf(larger)[m].value, measures[m].value + 0.011, 1e-12);
        // Seen from the old body's frame.
        const int held = *kind == BodyKind::sphere ? 2 : axis;
        const double shift = (body.X_SB.inverse() * larger.X_SB).translation()(held);
        const auto before = extentOf(body), after = extentOf(larger);
        const double old = hold < 0 ? before.min()(held) : hold > 0 ? before.max()(held) : before.center()(held);
        const double now = hold < 0 ? after.min()(held) : hold > 0 ? after.max()(held) : after.center()(held);
        EXPECT_NEAR(now + shift, old, 1e-12) << toString(picture) << " " << m << " " << hold;
      }
    }
  }
}

TEST(ToolSketch, FingersStayAtTheEndOfTheGripper) {
  Shape shape;
  shape.bodies = sketch(ToolPicture::gripper);
  const double gap = extentOf(shape).max().z();
  const Shape longer = resized(shape, ToolPicture::gripper, 0, 2, measuresOf(shape.bodies[0])[2].value + 0.02);
  EXPECT_NEAR(extentOf(longer).max().z(), gap + 0.02, 1e-12);
  EXPECT_NEAR(extentOf(longer).min().z(), 0, 1e-12);
  Shape turned = shape;
  for (ShapeBody& body : turned.bodies) body.X_SB = poseFromXyzRpy({0, 0, 0}, {1.5707963267948966, 0, 0}) * body.X_SB;
  const Shape sideways = resized(turned, ToolPicture::gripper, 0, 2, measuresOf(shape.bodies[0])[2].value + 0.02);
  EXPECT_NEAR(extentOf(sideways).min().y(), -(gap + 0.02), 1e-12) << "along the tool, wherever it points";
}

TEST(ToolSketch, TheLikelyUnitMakesATool) {
  EXPECT_EQ(likelyUnit(120.0), 0.001);
  EXPECT_EQ(likelyUnit(20.0), 0.001);
  EXPECT_EQ(likelyUnit(12.0), 0.01);
  EXPECT_EQ(likelyUnit(0.12), 1.0);
}

TEST(ToolSketch, WallsHaveALimit) {
  ShapeBody box = sketch(ToolPicture::box, Vector3d(0.06, 0.04, 0.1)).front();
  ASSERT_TRUE(wallLimit(box));
  EXPECT_NEAR(*wallLimit(box), 0.02, 1e-12);
  EXPECT_NEAR(*materialVolume(box), 0.06 * 0.04 * 0.1, 1e-12);
  box.wall = 0.01;
  EXPECT_NEAR(*materialVolume(box), 0.06 * 0.04 * 0.1 - 0.04 * 0.02 * 0.08, 1e-12);
  box.wall = 0.02;
  EXPECT_FALSE(materialVolume(box));
  EXPECT_NEAR(*wallLimit(box), 0.02, 1e-12);
  EXPECT_FALSE(wallLimit(sketch(ToolPicture::tube).front()));
}

}  // namespace
}  // namespace heft
