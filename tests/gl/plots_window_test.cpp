// Plots in the real window: further channels, one pane alone, the strip over the whole recording, preferences.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDialog>
#include <QDir>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <QWheelEvent>

#include "tests/gl/window_fixture.h"
#include "ui/timeline/marks_bar.h"
#include "ui/timeline/overview_strip.h"
#include "ui/wrench_plots/channel_lanes.h"
#include "ui/wrench_plots/recording_pane.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {
namespace {

const QString& plotsRecording() {
  static QTemporaryDir folder;
  static const QString file = [] {
    Payload tool;
    tool.mass = 0.7;
    tool.com = {0.01, 0.0, 0.05};
    tool.inertiaCom = Vector3d(0.0011, 0.0012, 0.0009).asDiagonal();
    SimulateOptions options;
    options.motion = MotionKind::excitation;
    options.duration = 8.0;
    options.seed = 5;
    return writeSimulated(folder, tool, options);
  }();
  return file;
}

class PlotsWindowTest : public RealWindowTest {
 protected:
  PlotsWindowTest() : RealWindowTest("plots") { QApplication::setActiveWindow(&window); }
  /// With the left button from one point over the middle to another.
  static void drag(QWidget* over, QPoint from, QPoint to) {
    QTest::mousePress(over, Qt::LeftButton, {}, from);
    for (const QPoint& at : {(from + to) / 2, to}) {
      QMouseEvent move(QEvent::MouseMove, at, over->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(over, &move);
    }
    QTest::mouseRelease(over, Qt::LeftButton, {}, to);
  }
  RecordingPane* pane() { return window.recordingPane(); }
  ChannelLanes* lanes() { return pane()->channels(); }
  /// An entry of the menu behind the button, as it is when it opens.
  QAction* channelAction(const QString& group, const QString& text) {
    auto* button = pane()->findChild<QToolButton*>("channelButton");
    emit button->menu()->aboutToShow();
    for (QAction* outer : button->menu()->actions()) {
      if (!outer->menu() || outer->text() != group) continue;
      for (QAction* inner : outer->menu()->actions())
        if (inner->text() == text) return inner;
    }
    return nullptr;
  }
};

TEST_F(PlotsWindowTest, AnyChannelOfTheRecordingCanBeSeen) {
  open(plotsRecording());
  EXPECT_FALSE(lanes()->isVisible());
  QAction* first = channelAction("Joint angles", "q1 [°]");
  ASSERT_NE(first, nullptr);
  first->trigger();
  EXPECT_TRUE(lanes()->isVisible());
  EXPECT_EQ(lanes()->lanes(), 1);
  QAction* speeds = channelAction("Joint speeds, from the angles", "All of these");
  if (!speeds) speeds = channelAction("Joint speeds", "All of these");
  ASSERT_NE(speeds, nullptr);
  speeds->trigger();
  EXPECT_EQ(lanes()->lanes(), 2);
  QTest::qWait(50);
  // Its curve has the scale of what is visible.
  const auto& recording = workspace.opened()->recording;
  const MinMax range = lanes()->laneRange(0);
  EXPECT_LT(range.lowest, recording.q.col(0).minCoeff() * 180 / M_PI);
  EXPECT_GT(range.highest, recording.q.col(0).maxCoeff() * 180 / M_PI);
  pane()->timeAxis()->show(2.0, 2.2);
  EXPECT_LT(lanes()->laneRange(0).highest - lanes()->laneRange(0).lowest, 0.7 * (range.highest - range.lowest));
  // A click moves the time, the wheel zooms, as in the lanes above.
  const int middle = (TimeAxis::kLeft + lanes()->width() - TimeAxis::kRight) / 2;
  QTest::mouseClick(lanes(), Qt::LeftButton, {}, {middle, 20});
  EXPECT_NEAR(window.playback()->time(), 2.1, 0.003);
  drag(lanes(), {middle - 100, 20}, {middle + 100, 20});
  EXPECT_LT(pane()->timeAxis()->span(), 0.15);
  channelAction("Joint angles", "q1 [°]")->trigger();
  EXPECT_FALSE(lanes()->isChosen("q1"));
  EXPECT_EQ(lanes()->lanes(), 1);
  // The joints tell where the sensor is: not further from the base than a Panda reaches.
  lanes()->setChosen({"pz"});
  pane()->timeAxis()->showAll();
  ASSERT_EQ(lanes()->lanes(), 1);
  EXPECT_GT(lanes()->laneRange(0).lowest, -600.0);
  EXPECT_LT(lanes()->laneRange(0).highest, 1300.0);
  EXPECT_GT(lanes()->laneRange(0).highest - lanes()->laneRange(0).lowest, 50.0);
}

TEST_F(PlotsWindowTest, OnePaneAloneAndBackByKeyAndButton) {
  open(plotsRecording());
  window.showStep(Step::mark);
  QTest::qWait(50);
  const int before = pane()->height();
  QTest::keyClick(&window, Qt::Key_F11);
  EXPECT_TRUE(pane()->isVisible());
  EXPECT_FALSE(window.robotView()->isVisible());
  EXPECT_FALSE(window.panel(Step::mark)->isVisible());
  QTest::qWait(50);
  EXPECT_GT(pane()->height(), 1.5 * before);
  QTest::keyClick(&window, Qt::Key_Escape);
  EXPECT_TRUE(window.robotView()->isVisible());
  EXPECT_TRUE(window.panel(Step::mark)->isVisible());
  QTest::qWait(50);
  EXPECT_NEAR(pane()->height(), before, 2);
  QTest::mouseClick(window.robotView()->findChild<QToolButton*>("aloneButton"), Qt::LeftButton);
  EXPECT_FALSE(pane()->isVisible());
  EXPECT_TRUE(window.robotView()->isVisible());
  // Another step is seen whole.
  window.showStep(Step::result);
  EXPECT_TRUE(window.panel(Step::result)->isVisible());
  EXPECT_TRUE(pane()->isVisible());
}

TEST_F(PlotsWindowTest, ZoomedInTheWholeRecordingStaysInSightAndPlayingTurnsThePage) {
  open(plotsRecording());
  auto* strip = pane()->findChild<QWidget*>("overviewStrip");
  auto* slider = pane()->findChild<QSlider*>("timeSlider");
  EXPECT_FALSE(strip->isVisible());
  TimeAxis* axis = pane()->timeAxis();
  axis->show(1.0, 3.0);
  EXPECT_TRUE(strip->isVisible());
  // The knob stands for the time on the plots' own scale.
  window.playback()->setTime(2.0);
  EXPECT_NEAR(slider->value() / double(slider->maximum()), 0.5, 0.01);
  QTest::qWait(50);
  const double wide = strip->width() - TimeAxis::kLeft - TimeAxis::kRight;
  const auto at = [&](double time) {
    return QPoint(static_cast<int>(TimeAxis::kLeft + time / axis->fullUpper() * wide), 10);
  };
  drag(strip, at(2.0), at(5.0));
  EXPECT_NEAR(axis->lower(), 4.0, 0.05);
  EXPECT_NEAR(axis->span(), 2.0, 1e-6);
  window.playback()->setTime(5.95);
  window.playback()->setPlaying(true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return axis->lower() > 5.9; }, 3000));
  window.playback()->setPlaying(false);
  QTest::keyClick(&window, Qt::Key_Home);
  EXPECT_EQ(axis->lower(), axis->fullLower());
  axis->showAll();
  EXPECT_FALSE(strip->isVisible());
}

TEST_F(PlotsWindowTest, EnterPressesTheFilledButtonWhereNothingElseWantsIt) {
  open(plotsRecording());
  window.showStep(Step::mark);
  pane()->plots()->setFocus();
  QTest::keyClick(pane()->plots(), Qt::Key_Return);
  EXPECT_EQ(window.step(), Step::shape);
}

TEST_F(PlotsWindowTest, NoButtonOfALow3dViewIsCut) {
  open(plotsRecording());
  window.resize(1024, 700);
  window.showStep(Step::mark);
  QTest::qWait(100);
  const auto buttons = window.robotView()->findChild<QWidget*>("viewTools")->findChildren<QToolButton*>();
  int shown = 0;
  for (const auto* button : buttons) {
    if (!button->isVisible()) continue;
    ++shown;
    const QRect at(button->mapTo(window.robotView(), QPoint()), button->size());
    EXPECT_TRUE(window.robotView()->rect().contains(at)) << qPrintable(button->toolTip());
  }
  EXPECT_GE(shown, 4);
}

TEST_F(PlotsWindowTest, AMarkIsTurnedIntoAnotherByItsMenu) {
  open(plotsRecording());
  window.showStep(Step::mark);
  workspace.paint(2.0, 4.0, MarkLabel::contact);
  QTest::qWait(50);
  MarksBar* bar = pane()->marks();
  const QPoint at(static_cast<int>(pane()->timeAxis()->toX(3.0, bar->width())), 18);
  ASSERT_NE(bar->segmentAt(at), nullptr);
  ASSERT_EQ(bar->segmentAt(at)->label, MarkLabel::contact);
  QStringList offered;
  QTimer::singleShot(100, [&] {
    auto* menu = bar->findChild<QMenu*>("marksMenu");
    ASSERT_NE(menu, nullptr);
    for (QAction* action : menu->actions()) {
      offered << action->text();
      if (action->text() == "Mark as ignored") action->trigger();
    }
    menu->close();
  });
  QContextMenuEvent wanted(QContextMenuEvent::Mouse, at, bar->mapToGlobal(at));
  QApplication::sendEvent(bar, &wanted);
  EXPECT_TRUE(offered.contains("Mark as free")) << qPrintable(offered.join(", "));
  EXPECT_EQ(bar->segmentAt(at)->label, MarkLabel::ignore);
  workspace.undoStack()->undo();
  EXPECT_EQ(bar->segmentAt(at)->label, MarkLabel::contact);
  // Delete takes back what was painted at the time shown, and nothing that was not painted.
  const int steps = workspace.undoStack()->index();
  window.playback()->setTime(6.0);
  QTest::keyClick(&window, Qt::Key_Delete);
  EXPECT_EQ(workspace.undoStack()->index(), steps);
  window.playback()->setTime(3.0);
  QTest::keyClick(&window, Qt::Key_Delete);
  EXPECT_EQ(workspace.undoStack()->index(), steps + 1);
  EXPECT_TRUE(workspace.session().recordings[0].marks.empty());
}

TEST_F(PlotsWindowTest, PreferencesTakeEffect) {
  const QString wanted = folder.filePath("elsewhere");
  qRegisterMetaType<ThemeKind>("heft::ThemeKind");
  qRegisterMetaType<UnitChoice>("heft::UnitChoice");
  QSignalSpy theme(&window, &MainWindow::themeWanted), units(&window, &MainWindow::unitsWanted);
  QTimer::singleShot(200, [&] {
    auto* dialog = window.findChild<QDialog*>("preferences");
    ASSERT_NE(dialog, nullptr);
    // Every key of the menus, and those of the window itself.
    auto* keys = dialog->findChild<QTableWidget*>("keyTable");
    QStringList all;
    for (int r = 0; r < keys->rowCount(); ++r) all << keys->item(r, 1)->text();
    for (const char* key : {"F1", "F11", "Ctrl+S", "Alt+3", "F6"}) EXPECT_TRUE(all.contains(key)) << key;
    dialog->findChild<QComboBox*>("preferredTheme")->setCurrentIndex(1);
    dialog->findChild<QComboBox*>("preferredMass")->setCurrentIndex(1);
    dialog->findChild<QComboBox*>("preferredTorque")->setCurrentIndex(1);
    dialog->findChild<QLineEdit*>("preferredFolder")->setText(wanted);
    if (qEnvironmentVariableIsSet("HEFT_TEST_PICTURES"))
      dialog->grab().save(QDir(qEnvironmentVariable("HEFT_TEST_PICTURES")).filePath("preferences.png"));
    dialog->accept();
  });
  window.findChild<QAction*>("editPreferences")->trigger();
  EXPECT_EQ(recordedFolder(), wanted);
  EXPECT_EQ(theme.count(), 1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return units.count() == 1; }, 1000));
  EXPECT_EQ(units[0][0].value<UnitChoice>(), (UnitChoice{true, false, true, false}));
}

TEST_F(PlotsWindowTest, ABoxAndTheWheelWithCtrlZoomValues) {
  open(plotsRecording());
  WrenchPlots* plots = pane()->plots();
  QWidget* canvas = plots->findChild<QWidget*>();
  const MinMax before = plots->laneRange(0);
  const double whole = before.highest - before.lowest;
  // Over half of the force lane's height: values and time.
  const int top = 12, x = canvas->width() / 2;
  drag(canvas, {x - 60, top}, {x + 60, top + 20});
  MinMax boxed = plots->laneRange(0);
  EXPECT_LT(boxed.highest - boxed.lowest, 0.8 * whole);
  EXPECT_LT(pane()->timeAxis()->span(), 4.0);
  QTest::mouseDClick(canvas, Qt::LeftButton, {}, {x, top + 8});
  EXPECT_NEAR(plots->laneRange(0).highest - plots->laneRange(0).lowest, whole, 1e-6 * whole);
  // Along the time the values stay those of the curves.
  drag(canvas, {x - 60, top + 8}, {x + 60, top + 11});
  EXPECT_LT(pane()->timeAxis()->span(), 4.0);
  QTest::mouseDClick(canvas, Qt::LeftButton, {}, {x, top + 8});
  const QPoint at(x, top + 8);
  QWheelEvent wheel(at, canvas->mapToGlobal(at), {}, QPoint(0, 120), Qt::NoButton, Qt::ControlModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(canvas, &wheel);
  const MinMax zoomed = plots->laneRange(0);
  EXPECT_NEAR(zoomed.highest - zoomed.lowest, 0.8 * whole, 0.02 * whole);
  EXPECT_TRUE(pane()->timeAxis()->showsAll());
}

}  // namespace
}  // namespace heft
