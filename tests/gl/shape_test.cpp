// The step Shape in the real window: pictures, typing and handles dragged with the mouse.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QLineEdit>
#include <QMouseEvent>
#include <QUndoStack>

#include "tests/gl/window_fixture.h"
#include "ui/shape_panel/shape_panel.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/stepper.h"

namespace heft {
namespace {

class ShapeWindowTest : public RealWindowTest {
 protected:
  ShapeWindowTest() : RealWindowTest("shape") {}
  /// A tool of 60 x 40 x 120 mm, all even, moved mostly without turning fast.
  void openSimulated() {
    Payload payload;
    payload.mass = 0.9;
    payload.com = {0, 0, 0.06};
    payload.inertiaCom =
        (0.9 / 12 * Vector3d(0.04 * 0.04 + 0.12 * 0.12, 0.06 * 0.06 + 0.12 * 0.12, 0.06 * 0.06 + 0.04 * 0.04))
            .asDiagonal();
    SimulateOptions options;
    options.motion = MotionKind::pickAndPlace;
    options.duration = 8.0;
    open(writeSimulated(folder, payload, options));
  }
  ShapePanel* panel() { return static_cast<ShapePanel*>(window.panel(Step::shape)); }
  void click(const char* name) {
    auto* button = window.findChild<QAbstractButton*>(name);
    ASSERT_NE(button, nullptr) << name;
    ASSERT_TRUE(button->isVisible()) << name;
    QTest::mouseClick(button, Qt::LeftButton);
    QApplication::processEvents();
  }
  const Shape& shape() { return workspace.session().shape.shape; }
  QWidget* viewport() { return window.robotView()->findChild<QWidget*>("viewport"); }
  void send(QEvent::Type type, QPointF at, Qt::MouseButtons held) {
    QMouseEvent event(type, at, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held, Qt::NoModifier);
    QApplication::sendEvent(viewport(), &event);
  }
};

TEST_F(ShapeWindowTest, AHandleIsDraggedWithTheMouseInOneUndoStep) {
  click("step_shape");
  ASSERT_EQ(window.step(), Step::shape);
  const QImage without = viewPicture();
  click("picture_box");
  const QImage with = viewPicture();
  EXPECT_GT(difference(without, with), 0.01) << "the tool is on the arm at once";
  const double before = shape().bodies[0].dims[2];
  const int edits = workspace.undoStack()->count();
  const auto knob = window.robotView()->handles().knob(2);  // height
  const auto centre = window.robotView()->handles().knob(0);
  ASSERT_TRUE(knob);
  ASSERT_TRUE(centre);
  send(QEvent::MouseMove, *knob, Qt::NoButton);
  EXPECT_EQ(panel()->handles()->current(), 2);
  EXPECT_EQ(viewport()->cursor().shape(), Qt::OpenHandCursor);
  send(QEvent::MouseButtonPress, *knob, Qt::LeftButton);
  EXPECT_EQ(viewport()->cursor().shape(), Qt::ClosedHandCursor);
  // Outwards along the arrow: away from the sensor is where the knob is.
  const QPointF origin = *window.robotView()->handles().knob(2);
  QPointF out(0, 1);
  {
    // Direction of the tool in the picture, from a knob half way along it to the one at its end.
    const QPointF along = *knob - *centre;
    out = along / std::hypot(along.x(), along.y());
  }
  for (int i = 1; i <= 5; ++i) send(QEvent::MouseMove, origin + 10.0 * i * out, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, origin + 50.0 * out, Qt::NoButton);
  EXPECT_GT(shape().bodies[0].dims[2], before + 0.005);
  EXPECT_NEAR(nearEnd(shape().bodies[0]).norm(), 0, 1e-9);
  EXPECT_EQ(workspace.undoStack()->count(), edits + 1);
  // The stepper follows.
  auto* field = window.findChild<Stepper*>("size_0_2");
  ASSERT_NE(field, nullptr);
  EXPECT_NEAR(field->value(), 1e3 * shape().bodies[0].dims[2], 1e-9);
  workspace.undoStack()->undo();
  EXPECT_EQ(shape().bodies[0].dims[2], before);
  EXPECT_NEAR(field->value(), 1e3 * before, 1e-9);
  // Beside the handles the mouse turns the view, as ever.
  const QImage still = viewPicture();
  send(QEvent::MouseButtonPress, {40, 300}, Qt::LeftButton);
  send(QEvent::MouseMove, {140, 320}, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, {140, 320}, Qt::NoButton);
  EXPECT_GT(difference(still, viewPicture()), 0.02);
}

TEST_F(ShapeWindowTest, ALengthIsTypedWhereItStandsInThePicture) {
  click("step_shape");
  click("picture_box");
  const double before = shape().bodies[0].dims[2];
  const int edits = workspace.undoStack()->count();
  auto* field = viewport()->findChild<QLineEdit*>("dimensionField");
  ASSERT_TRUE(field && !field->isVisible());
  const auto label = window.robotView()->handles().dimensionLabel(2);
  ASSERT_TRUE(label);
  send(QEvent::MouseMove, *label, Qt::NoButton);
  EXPECT_EQ(viewport()->cursor().shape(), Qt::IBeamCursor);
  QTest::mouseClick(viewport(), Qt::LeftButton, {}, label->toPoint());
  ASSERT_TRUE(field->isVisible());
  EXPECT_TRUE(field->geometry().contains(label->toPoint()));
  QTest::keyClicks(field, "17.5 cm");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_FALSE(field->isVisible());
  EXPECT_NEAR(shape().bodies[0].dims[2], 0.175, 1e-12);
  EXPECT_EQ(workspace.undoStack()->count(), edits + 1);
  EXPECT_NEAR(window.findChild<Stepper*>("size_0_2")->value(), 175, 1e-9);
  workspace.undoStack()->undo();
  EXPECT_EQ(shape().bodies[0].dims[2], before);
  // The handle itself, pressed and let go without dragging.
  const auto knob = window.robotView()->handles().knob(0);
  ASSERT_TRUE(knob);
  send(QEvent::MouseMove, *knob, Qt::NoButton);
  QTest::mouseClick(viewport(), Qt::LeftButton, {}, knob->toPoint());
  QApplication::processEvents();
  ASSERT_TRUE(field->isVisible());
  QTest::keyClicks(field, "123");
  QTest::keyClick(field, Qt::Key_Escape);
  EXPECT_FALSE(field->isVisible());
  EXPECT_EQ(workspace.undoStack()->index(), edits) << "Esc leaves it as it was";
  // What is no length is said, and changes nothing.
  QTest::mouseClick(viewport(), Qt::LeftButton, {}, window.robotView()->handles().dimensionLabel(2)->toPoint());
  ASSERT_TRUE(field->isVisible());
  QTest::keyClicks(field, "wide");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(shape().bodies[0].dims[2], before);
  EXPECT_TRUE(window.messageBar()->isVisible());
  EXPECT_TRUE(window.messageBar()->text().contains("wide"));
}

TEST_F(ShapeWindowTest, EscapePutsBackWhatADragChanged) {
  click("step_shape");
  click("picture_cylinder");
  click("modeMove");
  const Vector3d before = nearEnd(shape().bodies[0]);
  const auto knob = window.robotView()->handles().knob(10);  // along z
  ASSERT_TRUE(knob);
  send(QEvent::MouseButtonPress, *knob, Qt::LeftButton);
  for (const double d : {10.0, 30.0}) {
    send(QEvent::MouseMove, *knob + QPointF(0, d), Qt::LeftButton);
    send(QEvent::MouseMove, *knob - QPointF(0, d), Qt::LeftButton);
  }
  EXPECT_GT((nearEnd(shape().bodies[0]) - before).norm(), 1e-3);
  QTest::keyClick(viewport(), Qt::Key_Escape);
  EXPECT_NEAR((nearEnd(shape().bodies[0]) - before).norm(), 0, 1e-12);
  EXPECT_FALSE(panel()->handles()->dragging());
}

TEST_F(ShapeWindowTest, RingsTiltTheTool) {
  click("step_shape");
  click("picture_box");
  click("modeTurn");
  std::optional<QPointF> knob;
  int id = 0;
  for (id = 12; id < 15 && !knob; ++id) knob = window.robotView()->handles().knob(id);
  ASSERT_TRUE(knob);
  send(QEvent::MouseButtonPress, *knob, Qt::LeftButton);
  for (const double d : {10.0, 25.0, 40.0}) send(QEvent::MouseMove, *knob + QPointF(d, d), Qt::LeftButton);
  send(QEvent::MouseButtonRelease, *knob + QPointF(40, 40), Qt::NoButton);
  EXPECT_GT(vectorFromRotation(shape().bodies[0].X_SB.linear()).norm(), 0.02);
  EXPECT_NEAR(nearEnd(shape().bodies[0]).norm(), 0, 1e-9) << "about the end at the sensor";
}

TEST_F(ShapeWindowTest, TheEstimateUsesTheShapeAndTheToolStaysOnTheArm) {
  openSimulated();
  const auto before = workspace.report();
  const QImage plain = viewPicture();
  click("step_shape");
  ASSERT_TRUE(panel()->obey({"shape", "box", "60x40x120", "exact"})->ok());
  settle();
  ASSERT_TRUE(workspace.report());
  EXPECT_NE(workspace.report(), before);
  ASSERT_TRUE(workspace.snapshot().options.shape);
  // What the motion leaves open the shape narrows down, towards the truth.
  EXPECT_LT(workspace.report()->std.inertiaCom.norm(), before->std.inertiaCom.norm());
  EXPECT_NEAR(workspace.report()->payload.inertiaCom(0, 0), 0.0012, 0.0002);
  click("step_result");
  EXPECT_GT(difference(plain, viewPicture()), 0.002) << "the tool is still drawn";
  window.showStep(Step::shape);
  click("picture_unknown");
  settle();
  window.showStep(Step::result);
  EXPECT_LT(difference(plain, viewPicture()), 0.002);
}

TEST_F(ShapeWindowTest, EveryPictureIsDrawnAndFitsItsPanel) {
  click("step_shape");
  QImage last = viewPicture();
  for (const ToolPicture picture : kToolPictures) {
    if (picture == ToolPicture::mesh) continue;
    click(qPrintable(QStringLiteral("picture_") + QString::fromUtf8(toString(picture).data())));
    const QImage now = viewPicture();
    // A tube differs from a cylinder by its hole alone.
    EXPECT_GT(difference(last, now), 5e-5) << toString(picture);
    last = now;
  }
}

}  // namespace
}  // namespace heft
