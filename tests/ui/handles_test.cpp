#include <gtest/gtest.h>

#include <QSignalSpy>
#include <cmath>

#include "core/payload/shape_moments.h"
#include "ui/robot_view/handles.h"
#include "ui/robot_view/tool_solid.h"

namespace heft {
namespace {

HandleSet::View someView() {
  HandleSet::View view;
  view.camera.target = {0.4, 0.1, 0.5};
  view.camera.azimuth = -0.7;
  view.camera.elevation = 0.3;
  view.camera.distance = 1.1;
  view.size = QSizeF(900, 600);
  return view;
}

TEST(Ray, GoesThroughThePixelThatItsPointsHave) {
  const HandleSet::View view = someView();
  for (const Vector3d& p : {Vector3d(0.4, 0.1, 0.5), Vector3d(0.5, 0.2, 0.3), Vector3d(0.1, -0.2, 0.7)}) {
    const Ray ray = view.rayThrough(view.pixelOf(p));
    EXPECT_NEAR((p - ray.origin).cross(ray.direction).norm(), 0, 1e-12);
    const double perPixel = view.camera.metresPerPixel(p, 600);
    const QPointF beside = view.pixelOf(p + perPixel * view.camera.right());
    EXPECT_NEAR(beside.x() - view.pixelOf(p).x(), 1.0, 1e-9);
  }
}

TEST(HandleSet, ASliderFollowsThePointerAlongItsLineOnly) {
  const HandleSet::View view = someView();
  HandleSet set(HandleSet::Frame::sensor);
  const Isometry3d X_BF = poseFromXyzRpy({0.4, 0.1, 0.5}, {0.3, -0.2, 1.1});
  set.setPose(X_BF);
  Handle handle;
  handle.id = 7;
  handle.point = {0.02, 0.0, 0.05};
  handle.axis = Vector3d::UnitZ();
  handle.tone = 2;
  set.setHandles({handle});
  QSignalSpy grabbed(&set, &HandleSet::grabbed), released(&set, &HandleSet::released);
  HandleDrag last;
  QObject::connect(&set, &HandleSet::dragged, [&](const HandleDrag& drag) { last = drag; });
  const QPointF from = view.pixelOf(X_BF * handle.point);
  EXPECT_FALSE(set.press(from + QPointF(200, 0), view));
  ASSERT_TRUE(set.press(from, view));
  EXPECT_EQ(grabbed.size(), 1);
  EXPECT_TRUE(set.dragging());
  const QPointF to = view.pixelOf(X_BF * Vector3d(0.02, 0.0, 0.09));
  // The handle itself moving on meanwhile, as a listener does, changes nothing.
  handle.point.z() = 0.07;
  set.setHandles({handle});
  set.move(to, view, false);
  EXPECT_NEAR(last.along, 0.04, 1e-9);
  EXPECT_EQ(last.handle.id, 7);
  EXPECT_NEAR((last.shift - Vector3d(0, 0, 0.04)).norm(), 0, 1e-9);
  set.move(to, view, true);
  EXPECT_NEAR(last.along, 0.004, 1e-9);
  set.release();
  EXPECT_EQ(released.size(), 1);
  EXPECT_FALSE(set.dragging());
}

TEST(HandleSet, APlaneAndACircleAreFollowedToo) {
  const HandleSet::View view = someView();
  HandleSet set(HandleSet::Frame::base);
  set.setPose(poseFromXyzRpy({9, 9, 9}, {1, 1, 1}));  // Of no concern to base axes.
  Handle body;
  body.id = 1;
  body.way = Handle::Way::plane;
  body.point = {0.4, 0.1, 0.5};
  body.grabRadius = 0.08;
  body.shown = false;
  Handle ring;
  ring.id = 2;
  ring.way = Handle::Way::circle;
  ring.centre = {0.4, 0.1, 0.5};
  ring.axis = Vector3d::UnitZ();
  ring.point = ring.centre + Vector3d(0.2, 0, 0);
  set.setHandles({body, ring});
  HandleDrag last;
  QObject::connect(&set, &HandleSet::dragged, [&](const HandleDrag& drag) { last = drag; });

  const QPointF middle = view.pixelOf(body.point);
  ASSERT_TRUE(set.press(middle + QPointF(15, 10), view)) << "grabbed beside its middle, too";
  EXPECT_EQ(set.current(), 1);
  set.move(middle + QPointF(15 + 60, 10), view, false);
  EXPECT_NEAR((last.shift - 60 * view.camera.metresPerPixel(body.point, 600) * view.camera.right()).norm(), 0, 1e-9);
  set.release();

  ASSERT_TRUE(set.press(view.pixelOf(ring.point), view));
  EXPECT_EQ(set.current(), 2);
  // Round and round: the angle does not fall back at half a turn.
  for (int step = 1; step <= 40; ++step) {
    const double angle = step * 0.1;
    set.move(view.pixelOf(ring.centre + 0.2 * Vector3d(std::cos(angle), std::sin(angle), 0)), view, false);
  }
  EXPECT_NEAR(last.angle, 4.0, 1e-6);
  QSignalSpy cancelled(&set, &HandleSet::cancelled);
  set.cancel();
  EXPECT_EQ(cancelled.size(), 1);
}

TEST(HandleSet, ALineSeenFromItsEndIsNotOffered) {
  HandleSet::View view = someView();
  HandleSet set(HandleSet::Frame::base);
  Handle handle;
  handle.point = view.camera.target;
  handle.axis = (view.camera.target - view.camera.position()).normalized();
  set.setHandles({handle});
  EXPECT_FALSE(set.knob(0, view).has_value());
  EXPECT_FALSE(set.hover(view.pixelOf(handle.point), view));
  view.camera.azimuth += 0.8;
  EXPECT_TRUE(set.knob(0, view).has_value());
  EXPECT_TRUE(set.hover(view.pixelOf(handle.point), view));
}

/// Volume that the triangles enclose: right only if all are there and face outwards.
double enclosed(const MeshPart& part) {
  double sum = 0;
  for (const auto& t : part.triangles) {
    const Vector3d a = part.vertices[t[0]].cast<double>(), b = part.vertices[t[1]].cast<double>(),
                   c = part.vertices[t[2]].cast<double>();
    sum += a.dot(b.cross(c)) / 6;
  }
  return sum;
}

TEST(ToolSolid, EveryBodyIsDrawnWithItsOwnVolume) {
  const std::vector<std::pair<BodyKind, std::vector<double>>> bodies{
      {BodyKind::box, {0.06, 0.04, 0.12}},  {BodyKind::cylinder, {0.03, 0.1}}, {BodyKind::tube, {0.03, 0.02, 0.1}},
      {BodyKind::sphere, {0.05}},           {BodyKind::cone, {0.04, 0.1}},     {BodyKind::capsule, {0.03, 0.05}},
      {BodyKind::plate, {0.1, 0.1, 0.005}},
  };
  for (const auto& [kind, dims] : bodies) {
    ShapeBody body;
    body.kind = kind;
    body.dims = dims;
    const ToolSolid solid = makeToolSolid(body);
    const double volume = primitiveMoments(body)(3, 3);
    EXPECT_NEAR(enclosed(solid.faces), volume, 0.01 * volume) << toString(kind);
    EXPECT_FALSE(solid.edges.empty()) << toString(kind);
    EXPECT_TRUE(solid.hollow.empty()) << toString(kind);
    for (std::size_t i = 0; i < solid.faces.normals.size(); ++i)
      ASSERT_NEAR(solid.faces.normals[i].norm(), 1.0F, 1e-4F) << toString(kind);
  }
}

TEST(ToolSolid, AHollowBodyShowsItsInside) {
  ShapeBody body;
  body.kind = BodyKind::cylinder;
  body.dims = {0.03, 0.1};
  body.wall = 0.004;
  const ToolSolid solid = makeToolSolid(body);
  ASSERT_FALSE(solid.hollow.empty());
  EXPECT_NEAR(solid.hollow[0][0].head<2>().norm(), 0.026, 1e-12);
  body.dims = {0.03};
  EXPECT_TRUE(makeToolSolid(body).faces.triangles.empty()) << "impossible numbers draw nothing";
}

}  // namespace
}  // namespace heft
