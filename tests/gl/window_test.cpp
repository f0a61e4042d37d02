#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLayout>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>
#include <QUrl>
#include <cmath>
#include <set>

#include "tests/gl/window_fixture.h"
#include "ui/widgets/message_bar.h"
#include "ui/wrench_plots/recording_pane.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {
namespace {

constexpr double kTrueMass = 0.9;

/// A short simulated recording on disk, made once.
const QString& simulatedFile() {
  static QTemporaryDir folder;
  static const QString file = [] {
    Payload payload;
    payload.mass = kTrueMass;
    payload.com = {0.005, -0.01, 0.06};
    payload.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
    SimulateOptions options;
    options.motion = MotionKind::excitation;
    options.duration = 8.0;
    options.seed = 3;
    return writeSimulated(folder, payload, options);
  }();
  return file;
}

int distinctColours(const QImage& image) {
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, y));
  return static_cast<int>(colours.size());
}

class WindowTest : public RealWindowTest {
 protected:
  WindowTest() : RealWindowTest("window") {}
  void waitUntilSettled() { settle(250); }
  void openSimulated() { open(simulatedFile()); }
};

TEST_F(WindowTest, WelcomesWithAnArmAndOneThingToDo) {
  waitUntilSettled();
  EXPECT_FALSE(window.recordingPane()->isVisible());
  auto* main = window.panel(Step::record)->findChild<QPushButton*>("mainButton");
  ASSERT_NE(main, nullptr);
  EXPECT_TRUE(main->isVisible());
  EXPECT_GT(distinctColours(viewPicture()), 500);
}

TEST_F(WindowTest, APanelIsAsHighAsItNeedsWheneverAStepIsEntered) {
  window.resize(1280, 800);
  openSimulated();
  for (int round = 0; round < 2; ++round) {
    for (const Step step : {Step::shape, Step::exportFile, Step::mark, Step::result}) {
      window.showStep(step);
      QApplication::processEvents();
      QTest::qWait(100);
      const auto* content = window.panel(step)->findChild<QWidget*>("panelContent");
      ASSERT_NE(content, nullptr);
      EXPECT_GE(content->height(), content->layout()->totalHeightForWidth(content->width()))
          << stepId(step) << ", round " << round;
      for (const auto* label : content->findChildren<QLabel*>())
        if (label->isVisible() && label->wordWrap()) {
          EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
        }
    }
  }
}

TEST_F(WindowTest, StepsSwitchByMouseAndKeys) {
  openSimulated();
  EXPECT_EQ(window.step(), Step::result);
  auto* record = window.findChild<QAbstractButton*>("step_record");
  ASSERT_NE(record, nullptr);
  QTest::mouseClick(record, Qt::LeftButton);
  EXPECT_EQ(window.step(), Step::record);
  EXPECT_TRUE(window.panel(Step::record)->isVisible());
  EXPECT_FALSE(window.panel(Step::result)->isVisible());
  QApplication::setActiveWindow(&window);  // Without a window manager nobody else does.
  QTest::keyClick(&window, Qt::Key_4, Qt::AltModifier);
  EXPECT_EQ(window.step(), Step::result);
}

TEST_F(WindowTest, A3dViewThatIsBlankFails) {
  openSimulated();
  const QImage view = viewPicture();
  // The same stage with nobody on it: what a view looks like that lost its arm. The limits must tell the two apart.
  RobotView empty;
  empty.resize(window.robotView()->size());
  empty.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&empty));
  empty.renderNow();
  const QImage blank = empty.grab().toImage().convertToFormat(QImage::Format_RGB32);
  EXPECT_LT(distinctColours(blank), 1000);
  EXPECT_GT(distinctColours(view), 2000);
  EXPECT_GT(difference(view, blank), 0.04);
}

TEST_F(WindowTest, TheArmMovesWithTime) {
  openSimulated();
  window.playback()->setTime(1.0);
  const QImage first = viewPicture();
  window.playback()->setTime(4.0);
  const QImage second = viewPicture();
  window.playback()->setTime(1.0);
  const QImage again = viewPicture();
  EXPECT_GT(difference(first, second), 0.02);
  EXPECT_LT(difference(first, again), 0.001);
}

TEST_F(WindowTest, TheEstimateIsShownAndNearTheTruth) {
  openSimulated();
  EXPECT_NEAR(workspace.report()->payload.mass, kTrueMass, 0.02);
  bool found = false;
  for (const QLabel* label : window.panel(Step::result)->findChildren<QLabel*>())
    found = found || label->text() == "Your tool weighs 0.90 kg.";
  EXPECT_TRUE(found);
  EXPECT_GT(window.recordingPane()->plots()->pointsDrawn(), 5000);
}

TEST_F(WindowTest, MouseTurnsTheView) {
  openSimulated();
  const QImage before = viewPicture();
  auto* viewport = window.robotView()->findChild<QWidget*>("viewport");
  ASSERT_NE(viewport, nullptr);
  QTest::mousePress(viewport, Qt::LeftButton, {}, {300, 200});
  QMouseEvent move(QEvent::MouseMove, QPointF(400, 220), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(viewport, &move);
  QTest::mouseRelease(viewport, Qt::LeftButton, {}, {400, 220});
  EXPECT_GT(difference(before, viewPicture()), 0.02);
  QTest::mouseClick(window.findChild<QToolButton*>("fitButton"), Qt::LeftButton);
  EXPECT_LT(difference(before, viewPicture()), 0.005);
}

TEST_F(WindowTest, TheToolViewComesCloser) {
  openSimulated();
  window.playback()->setTime(3.0);
  const QImage overview = viewPicture();
  auto* tool = window.findChild<QToolButton*>("toolButton");
  ASSERT_NE(tool, nullptr);
  QTest::mouseClick(tool, Qt::LeftButton);
  EXPECT_GT(difference(overview, viewPicture()), 0.1);
}

TEST_F(WindowTest, SpacePlaysAndPauses) {
  openSimulated();
  window.setFocus();
  QTest::keyClick(&window, Qt::Key_Space);
  EXPECT_TRUE(window.playback()->playing());
  const double before = window.playback()->time();
  QTest::qWait(300);
  EXPECT_GT(window.playback()->time(), before);
  QTest::keyClick(&window, Qt::Key_Space);
  EXPECT_FALSE(window.playback()->playing());
  const double paused = window.playback()->time();
  QTest::keyClick(&window, Qt::Key_Right);
  EXPECT_NEAR(window.playback()->time(), paused + 0.1, 1e-9);
}

TEST_F(WindowTest, ABadFileIsOneSentenceAndKeepsWhatIsOpen) {
  openSimulated();
  const QString bad = folder.filePath("bad.csv");
  QFile file(bad);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("time,fx\n0,hello\n");
  file.close();
  workspace.open(bad);
  waitUntilSettled();
  EXPECT_TRUE(window.messageBar()->isVisible());
  EXPECT_TRUE(window.messageBar()->text().contains("bad.csv")) << window.messageBar()->text().toStdString();
  EXPECT_EQ(workspace.opened()->path, simulatedFile());
  EXPECT_TRUE(workspace.report());
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
}

TEST_F(WindowTest, ADroppedFileOpens) {
  waitUntilSettled();
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(simulatedFile())});
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &drop);
  waitUntilSettled();
  ASSERT_TRUE(workspace.opened());
  EXPECT_EQ(workspace.opened()->path, simulatedFile());
}

TEST_F(WindowTest, StoppingTheEstimateLeavesTheRecordingOpen) {
  workspace.open(simulatedFile());
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace.opened() != nullptr; }, 60000));
  workspace.cancel();
  waitUntilSettled();
  // Either it was stopped in time, or the estimate was quicker: both leave a usable window.
  auto* main = window.panel(Step::result)->findChild<QPushButton*>("mainButton");
  EXPECT_TRUE(main->isVisible());
  if (!workspace.report()) {
    QTest::mouseClick(main, Qt::LeftButton);
    waitUntilSettled();
  }
  EXPECT_TRUE(workspace.report());
}

TEST_F(WindowTest, DarkThemeReachesEveryPart) {
  openSimulated();
  const QImage light = window.picture();
  applyTheme(*qApp, ThemeKind::dark);
  QTest::qWait(300);
  const QImage dark = window.picture();
  applyTheme(*qApp, ThemeKind::light);
  int bright = 0;
  for (int y = 0; y < dark.height(); y += 2)
    for (int x = 0; x < dark.width(); x += 2) bright += dark.pixelColor(x, y).lightness() > 150;
  EXPECT_LT(bright, dark.width() * dark.height() / 4 / 8);
  QTest::qWait(300);
  EXPECT_LT(difference(light, window.picture()), 0.01);
}

TEST_F(WindowTest, EveryControlCanBeReachedAndHasAName) {
  openSimulated();
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus) continue;
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    if (button == nullptr) continue;
    EXPECT_FALSE(button->text().isEmpty() && button->accessibleName().isEmpty()) << widget->objectName().toStdString();
  }
}

/// A sensor that turns in place, without a robot: a note stands at the top left, and the force points to all sides.
TEST_F(WindowTest, LabelsKeepClearOfTheNoteAndOfEachOther) {
  QString text = "time,qx,qy,qz,qw,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 800; ++k) {
    const double t = 0.01 * k, a = 1.4 * std::sin(1.1 * t), b = 1.2 * std::sin(0.8 * t + 1);
    const Eigen::Quaterniond turn =
        Eigen::AngleAxisd(a, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(b, Eigen::Vector3d::UnitY());
    const Eigen::Vector3d f = turn.conjugate() * Eigen::Vector3d(0, 0, 9.81),
                          tau = Eigen::Vector3d(0.01, 0, 0.06).cross(f);
    text += QStringLiteral("%1,%2,%3,%4,%5").arg(t).arg(turn.x()).arg(turn.y()).arg(turn.z()).arg(turn.w());
    for (const double each : {f.x(), f.y(), f.z(), tau.x(), tau.y(), tau.z()})
      text += QStringLiteral(",%1").arg(each + 0.01 * ((k * 7919) % 13 - 6));
    text += "\n";
  }
  QFile file(folder.filePath("turning.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text.toUtf8());
  file.close();
  open(file.fileName());
  RobotView* view = window.robotView();
  int labels = 0;
  for (const QSize size : {QSize(960, 620), QSize(1280, 800)}) {
    window.resize(size);
    for (const Step step : {Step::mark, Step::shape, Step::result}) {
      window.showStep(step);
      waitUntilSettled();
      for (double time = 0.0; time < 8.0; time += 1.3) {
        window.playback()->setTime(time);
        QTest::qWait(40);
        view->renderNow();
        const auto places = view->labelPlaces();
        const QRectF note = view->note().notePlace(), picture(QPointF(0, 0), QSizeF(view->size()));
        EXPECT_FALSE(note.isEmpty());
        for (std::size_t i = 0; i < places.size(); ++i) {
          ++labels;
          EXPECT_FALSE(places[i].intersects(note)) << stepId(step) << " at " << time << " s";
          EXPECT_TRUE(picture.contains(places[i])) << stepId(step) << " at " << time << " s";
          for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(places[i].intersects(places[j])) << stepId(step) << " at " << time << " s";
        }
      }
    }
  }
  EXPECT_GT(labels, 50);
}

}  // namespace
}  // namespace heft
