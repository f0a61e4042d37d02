// The virtual arm in the real window: guided with mouse and keys, recorded, opened.
#include <gtest/gtest.h>

#include <QFile>
#include <QPushButton>
#include <QUndoStack>
#include <cmath>

#include "tests/gl/window_fixture.h"
#include "ui/record_panel/flange_guide.h"
#include "ui/record_panel/record_panel.h"
#include "ui/robot_view/viewport.h"
#include "ui/theme/theme.h"
#include "ui/wrench_plots/recording_pane.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {
namespace {

class LiveWindowTest : public RealWindowTest {
 protected:
  LiveWindowTest() : RealWindowTest("live") {
    panel = dynamic_cast<RecordPanel*>(window.panel(Step::record));
    viewport = window.robotView()->findChild<Viewport*>("viewport");
  }
  void pass(double seconds) {
    panel->run()->pass(seconds);
    settle();
  }
  QPoint knob(int id) { return panel->guide()->handles()->knob(id, viewport->handleView())->toPoint(); }
  void dragBy(QPoint from, QPoint by) {
    QTest::mousePress(viewport, Qt::LeftButton, {}, from);
    for (int k = 1; k <= 8; ++k) {
      QTest::mouseMove(viewport, from + by * k / 8);
      QTest::qWait(5);
      panel->run()->pass(0.2);
      settle();
    }
  }

  RecordPanel* panel = nullptr;
  Viewport* viewport = nullptr;
};

TEST_F(LiveWindowTest, DraggingTheToolMovesTheJointsAndTheArmFollows) {
  panel->startVirtual(3, false, false);
  pass(0.5);
  ASSERT_TRUE(panel->run()->view().q);
  const VectorXd q = *panel->run()->view().q;
  const Vector3d at = panel->run()->view().X_BS.translation();
  dragBy(knob(0), {120, -60});
  QTest::mouseRelease(viewport, Qt::LeftButton, {}, knob(0));
  pass(1.0);
  const Vector3d moved = panel->run()->view().X_BS.translation() - at;
  EXPECT_GT((*panel->run()->view().q - q).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_GT(moved.norm(), 0.05);
  EXPECT_GT(moved.dot(viewport->camera().right()), 0.03) << "to the right, as the mouse";
  EXPECT_LT((window.robotView()->sensorPose().translation() - panel->run()->view().X_BS.translation()).norm(), 1e-6)
      << "the picture shows it";
  // Let go, it rests.
  pass(1.0);
  const VectorXd rest = *panel->run()->view().q;
  pass(1.0);
  EXPECT_LT((*panel->run()->view().q - rest).cwiseAbs().maxCoeff(), 2e-3);
}

TEST_F(LiveWindowTest, ARingTurnsTheToolAndKeysMoveIt) {
  panel->startVirtual(3, false, false);
  pass(0.5);
  const Isometry3d before = panel->run()->view().X_BS;
  int ring = -1;
  for (int id = 1; id <= 3 && ring < 0; ++id)
    if (panel->guide()->handles()->knob(id, viewport->handleView())) ring = id;
  ASSERT_GT(ring, 0);
  const QPoint spoke = knob(ring) - knob(0);
  const double length = std::max(1.0, std::hypot(spoke.x(), spoke.y()));
  dragBy(knob(ring), QPoint(std::lround(-60 * spoke.y() / length), std::lround(60 * spoke.x() / length)));
  QTest::mouseRelease(viewport, Qt::LeftButton, {}, {5, 5});
  pass(1.0);
  const Isometry3d turned = panel->run()->view().X_BS;
  EXPECT_GT(vectorFromRotation(before.linear().transpose() * turned.linear()).norm(), 0.08);
  viewport->setFocus();
  for (int k = 0; k < 4; ++k) QTest::keyClick(viewport, Qt::Key_Up);
  pass(2.0);
  EXPECT_NEAR(panel->run()->view().X_BS.translation().z() - turned.translation().z(), 0.08, 0.02);
}

TEST_F(LiveWindowTest, PlotsRunTheGhostStandsThereAndStopOpensTheRecording) {
  ASSERT_TRUE(panel->obey({"live", "virtual", "10", "7"})->ok());
  settle();
  auto* plots = window.findChild<RecordingPane*>("livePlots");
  ASSERT_TRUE(plots && plots->isVisible());
  EXPECT_GT(plots->plots()->pointsDrawn(), 1000);
  EXPECT_NEAR(plots->plots()->traces()->lastTime(), 10.0, 0.05);
  ASSERT_TRUE(panel->run()->advice());
  window.robotView()->renderNow();
  const QImage picture = window.robotView()->grab().toImage().convertToFormat(QImage::Format_RGB32);
  int accent = 0;
  for (int y = 0; y < picture.height(); y += 2)
    for (int x = 0; x < picture.width(); x += 2) {
      const QColor c = picture.pixelColor(x, y);
      accent += c.red() - c.green() > 25 && c.blue() - c.green() > 12;
    }
  EXPECT_GT(accent, 150) << "the suggested motion in the accent colour";
  QTest::mouseClick(panel->findChild<QPushButton*>("mainButton"), Qt::LeftButton);
  settle();
  ASSERT_TRUE(workspace.opened());
  ASSERT_TRUE(workspace.report());
  EXPECT_EQ(window.step(), Step::result);
  EXPECT_NEAR(workspace.report()->payload.mass, practiceTool(7).mass, 0.05 * practiceTool(7).mass);
  EXPECT_FALSE(plots->isVisible());
}

TEST_F(LiveWindowTest, TheRoomStandsInTheViewAndTheGapTurnsRedWithinTheMargin) {
  const auto table = [&](double height) {
    const QString path = folder.filePath("room.json");
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QStringLiteral(R"({"schema": "heft.room/1", "margin_m": 0.02, "obstacles": [
        {"name": "table", "box": {"size_m": [0.5, 0.5, 0.02], "xyz_m": [0.55, 0, %1]}}]})")
                   .arg(height - 0.01)
                   .toUtf8());
    return path;
  };
  const auto gapOf = [&](double height) {
    EXPECT_TRUE(panel->obey({"room", table(height)})->ok());
    panel->startVirtual(3, false, false);
    pass(2.0);
    return window.robotView()->marks().gap();
  };
  const auto red = [&] {
    const QImage picture = viewPicture();
    const QColor bad = theme().bad;
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) count += picture.pixelColor(x, y) == bad;
    return count;
  };
  EXPECT_FALSE(panel->obey({"room", folder.filePath("none.json")})->ok());
  EXPECT_TRUE(workspace.session().room.empty());

  const auto far = gapOf(0.25);
  ASSERT_TRUE(far);
  EXPECT_EQ(far->second, "table");
  EXPECT_FALSE(far->tooNear());
  EXPECT_EQ(red(), 0);
  const auto labelled = [&](const QString& text) { return window.robotView()->labelTexts().filter(text).size() == 1; };
  EXPECT_TRUE(labelled("mm"));
  keepPicture(window, "live-room-far");
  const double lowest = panel->run()->clearance()->nearest(*panel->run()->view().q).onFirst.z();
  ASSERT_TRUE(panel->obey({"live", "discard"})->ok());

  // A finger's breadth below the tool: nothing can be proposed, and the arm itself is too near.
  const auto near = gapOf(lowest - 0.012);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->second, "table");
  EXPECT_TRUE(near->tooNear()) << near->distance;
  EXPECT_GT(red(), 0);
  EXPECT_TRUE(labelled("Too near"));
  EXPECT_TRUE(panel->run()->refusal().contains("table")) << panel->run()->refusal().toStdString();
  EXPECT_TRUE(texts(Step::record).contains("12 mm"));
  keepPicture(window, "live-room-near");
  ASSERT_TRUE(panel->obey({"live", "discard"})->ok());
  settle();
  EXPECT_FALSE(window.robotView()->marks().gap()) << "with the run it goes";

  panel->setWay(RecordPanel::Way::virtualArm);
  EXPECT_TRUE(texts(Step::record).contains("room.json: 1 obstacle")) << texts(Step::record).toStdString();
  QTest::mouseClick(panel->findChild<QPushButton*>("removeRoom"), Qt::LeftButton);
  EXPECT_TRUE(workspace.session().room.empty());
  EXPECT_FALSE(texts(Step::record).contains("room.json"));
  workspace.undoStack()->undo();
  EXPECT_EQ(workspace.session().room.filename(), "room.json");
}

TEST_F(LiveWindowTest, OtherStepsAreReachableMeanwhileAndTheRunGoesOn) {
  ASSERT_TRUE(panel->obey({"live", "virtual", "2", "7"})->ok());
  settle();
  window.showStep(Step::exportFile);
  pass(1.0);
  EXPECT_NEAR(panel->run()->view().time, 2.999, 1e-6);
  window.showStep(Step::record);
  EXPECT_TRUE(window.findChild<RecordingPane*>("livePlots")->isVisible());
  ASSERT_TRUE(panel->obey({"live", "discard"})->ok());
  settle();
  EXPECT_FALSE(panel->run()->running());
  EXPECT_FALSE(workspace.opened());
}

}  // namespace
}  // namespace heft
