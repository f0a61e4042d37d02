// What the program finds is shown in every step, and nothing that was recorded is lost: in the real window, by mouse.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QWheelEvent>

#include "core/base/json_file.h"
#include "core/simulation/virtual_rig.h"
#include "tests/gl/window_fixture.h"
#include "ui/controller/autosave.h"
#include "ui/reality_panel/difference_pane.h"
#include "ui/reality_panel/difference_traces.h"
#include "ui/reality_panel/reality_panel.h"
#include "ui/record_panel/record_panel.h"
#include "ui/shape_panel/shape_panel.h"
#include "ui/timeline/time_axis.h"
#include "ui/widgets/message_bar.h"
#include "ui/wrench_plots/recording_pane.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {
namespace {

class HonestyTest : public RealWindowTest {
 protected:
  HonestyTest() : RealWindowTest("honesty") {}

  void openWith(std::vector<EffectRequest> effects, std::uint64_t seed = 4711) {
    Payload tool;
    tool.mass = 0.8;
    tool.com = {0.005, -0.01, 0.06};
    tool.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
    SimulateOptions options;
    options.duration = 10.0;
    options.rateHz = 500.0;
    options.seed = seed;
    options.effects = std::move(effects);
    open(writeSimulated(folder, tool, options));
  }
  template <class Widget>
  Widget* find(Step step, const char* name) {
    for (Widget* each : window.panel(step)->findChildren<Widget*>(name))
      if (each->isVisible()) return each;
    return nullptr;
  }
  void click(Step step, const char* name) {
    auto* button = find<QAbstractButton>(step, name);
    ASSERT_NE(button, nullptr) << name;
    QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(12, button->height() / 2));
    settle();
  }
  RecordPanel* record() { return dynamic_cast<RecordPanel*>(window.panel(Step::record)); }
  QStringList kept() { return QDir(recordedFolder()).entryList({"*.csv"}, QDir::Files); }
};

TEST_F(HonestyTest, ACauseThatIsNotAppliedIsToldInResultAndExportAndHoldsTheFileBack) {
  openWith({{"cable_pull", "", 2.0}});
  window.showStep(Step::realityCheck);
  settle();
  ASSERT_TRUE(dynamic_cast<RealityPanel*>(window.panel(Step::realityCheck))->report());
  ASSERT_EQ(window.panel(Step::realityCheck)->state().light, Light::look);
  // Result: no green light beside a number that the cause moves.
  EXPECT_EQ(window.panel(Step::result)->state().light, Light::look);
  window.showStep(Step::result);
  settle();
  EXPECT_TRUE(texts(Step::result).contains("not applied")) << texts(Step::result).toStdString();
  // Export: said, in the file, and saving waits for a word.
  window.showStep(Step::exportFile);
  settle();
  click(Step::exportFile, "format_kuka");
  click(Step::exportFile, "roleOwnTool");
  EXPECT_TRUE(texts(Step::exportFile).contains("not applied")) << texts(Step::exportFile).toStdString();
  EXPECT_EQ(window.panel(Step::exportFile)->state().light, Light::look);
  EXPECT_TRUE(
      window.panel(Step::exportFile)->ownPane()->findChild<QPlainTextEdit*>()->toPlainText().contains("CAUTION"));
  auto* save = find<QPushButton>(Step::exportFile, "mainButton");
  ASSERT_NE(save, nullptr);
  EXPECT_FALSE(save->isEnabled());
  click(Step::exportFile, "saveAllTheSame");
  EXPECT_TRUE(find<QPushButton>(Step::exportFile, "mainButton")->isEnabled());
  // Once it is applied nothing is left to be told.
  window.showStep(Step::realityCheck);
  settle();
  click(Step::realityCheck, "mainButton");
  EXPECT_FALSE(workspace.corrections().causes.empty());
  window.showStep(Step::result);
  settle();
  EXPECT_FALSE(texts(Step::result).contains("not applied"));
}

TEST_F(HonestyTest, TheBandInThePlotsIsTheSensorsNoiseNotTheMisfit) {
  openWith({});
  const double force = window.recordingPane()->plots()->traces()->noiseBand(0),
               torque = window.recordingPane()->plots()->traces()->noiseBand(3);
  const SensorModel usual;
  // Samples are averaged for the estimate, and noise with a memory does not show from one to the next.
  EXPECT_GT(force, 0.5 * usual.forceNoise);
  EXPECT_LT(force, 2.0 * usual.forceNoise);
  openWith({{"cable_pull", "", 3.0}});
  const auto& traces = *window.recordingPane()->plots()->traces();
  EXPECT_NEAR(traces.noiseBand(0), force, 0.15 * force) << "a cable is no noise";
  EXPECT_NEAR(traces.noiseBand(3), torque, 0.15 * torque);
  EXPECT_GT(traces.differenceLimit(0), 3.0 * traces.noiseBand(0)) << "it stands far out of the band";
}

TEST_F(HonestyTest, TheDifferenceStandsBelowTheArmAndIsAlive) {
  openWith({{"time_offset", "", 15.0}});
  window.showStep(Step::realityCheck);
  settle();
  auto* pane = window.panel(Step::realityCheck)->ownPane()->findChild<DifferencePane*>();
  ASSERT_NE(pane, nullptr);
  ASSERT_TRUE(pane->isVisible()) << "without a click";
  TimeAxis* axis = window.recordingPane()->timeAxis();
  EXPECT_LT(axis->span(), 1.0) << "zoomed to where a delay shows";
  window.showStep(Step::result);
  EXPECT_GT(axis->span(), 5.0) << "that belongs to the reality check";
  window.showStep(Step::realityCheck);
  EXPECT_LT(axis->span(), 1.0) << "each time one comes there";
  EXPECT_NEAR(pane->traces()->curves().delay, 0.015, 0.003);
  const auto& curves = pane->traces()->curves();
  ASSERT_GT(curves.time.size(), 100);
  double before = 0.0, after = 0.0;
  for (int i = 0; i < curves.time.size(); ++i)
    if (std::isfinite(curves.value(3, i)))
      before += std::pow(curves.value(3, i), 2), after += std::pow(curves.value(4, i), 2);
  EXPECT_LT(after, 0.5 * before);
  // A click moves the time of arm and plots, the wheel zooms all of them.
  QWidget* traces = pane->traces();
  QTest::mouseClick(traces, Qt::LeftButton, {}, QPoint(traces->width() / 2, traces->height() / 3));
  EXPECT_NEAR(window.playback()->time(), 0.5 * (axis->lower() + axis->upper()), 0.1);
  const double span = axis->span();
  const QPointF middle(traces->width() / 2.0, traces->height() / 3.0);
  QWheelEvent out(middle, traces->mapToGlobal(middle.toPoint()), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                  Qt::NoScrollPhase, false);
  QApplication::sendEvent(traces, &out);
  EXPECT_GT(axis->span(), 1.1 * span);
  // What is saved as a picture of the plots is what stands there.
  EXPECT_EQ(window.pictureOf("plots").size(), pane->grab().toImage().size());
}

TEST_F(HonestyTest, AnotherWayOfRecordingKeepsWhatCame) {
  record()->startVirtual(3, false, false);
  record()->run()->pass(6.0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return record()->run()->view().time > 5.9; }, 60000));
  settle();
  const QString file = record()->run()->file();
  auto* poses = record()->findChild<QPushButton*>("posesButton");
  ASSERT_NE(poses, nullptr);
  QTest::mouseClick(poses, Qt::LeftButton);
  EXPECT_TRUE(record()->run()->poses());
  EXPECT_TRUE(QFileInfo::exists(file)) << "six seconds are not thrown away";
  EXPECT_TRUE(window.messageBar()->text().contains(QFileInfo(file).fileName()));
  record()->run()->discard();
}

TEST_F(HonestyTest, ClosingTheWindowKeepsTheRecordingInAFolderThatTheUserKnows) {
  record()->startVirtual(3, false, false);
  record()->run()->pass(4.0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return record()->run()->view().time > 3.9; }, 60000));
  settle();
  window.close();
  EXPECT_FALSE(record()->run()->running());
  ASSERT_EQ(kept().size(), 1);
  EXPECT_GT(QFileInfo(QDir(recordedFolder()).filePath(kept().front())).size(), 1000);
}

TEST_F(HonestyTest, TheWheelScrollsAndChangesNoValueUnderThePointer) {
  openWith({});
  window.resize(1100, 640);
  window.showStep(Step::shape);
  settle();
  click(Step::shape, "picture_box");
  const Shape before = workspace.session().shape.shape;
  auto* area = window.panel(Step::shape)->findChild<QScrollArea*>("panelScroll");
  ASSERT_NE(area, nullptr);
  int combos = 0;
  for (auto* box : window.panel(Step::shape)->findChildren<QComboBox*>()) {
    if (!box->isVisible()) continue;
    ++combos;
    const int index = box->currentIndex();
    const QPointF at(box->width() / 2.0, box->height() / 2.0);
    QWheelEvent down(at, box->mapToGlobal(at.toPoint()), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                     false);
    const int scrolled = area->verticalScrollBar()->value();
    QApplication::sendEvent(box, &down);
    EXPECT_EQ(box->currentIndex(), index) << box->objectName().toStdString();
    EXPECT_FALSE(down.isAccepted()) << "what scrolls around it has to get the event";
    Q_UNUSED(scrolled);
  }
  EXPECT_GT(combos, 0);
  EXPECT_EQ(workspace.session().shape.shape.bodies.front().dims, before.bodies.front().dims);
  EXPECT_EQ(workspace.session().shape.shape.bodies.front().density, before.bodies.front().density);
}

TEST_F(HonestyTest, NewLeavesNothingOfTheOldRecordingInTheView) {
  openWith({});
  window.playback()->setTime(3.0);
  workspace.startAfresh();
  settle(400);
  EXPECT_EQ(workspace.opened(), nullptr);
  // The labels go with the next frame, which a busy machine draws late.
  EXPECT_TRUE(QTest::qWaitFor([&] { return window.robotView()->labelTexts().isEmpty(); }, 5000))
      << window.robotView()->labelTexts().join("|").toStdString();
}

TEST_F(HonestyTest, AFileThatIsRefusedIsToldEvenAfterAnotherFailure) {
  const auto write = [&](const char* name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  };
  QByteArray head = "time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz\n", rows;
  for (int k = 0; k < 40; ++k) rows += QByteArray::number(0.005 * k) + ",0,0,0,-1.5,0,1.5,0,0,0,8,0,0,0\n";
  workspace.open(write("short.csv", head + rows));
  settle();
  const QString first = window.messageBar()->text();
  ASSERT_FALSE(workspace.report());
  ASSERT_FALSE(first.isEmpty());
  EXPECT_FALSE(window.panel(Step::mark)->state().line.contains("check")) << "nothing is under way any more";
  workspace.open(write("headonly.csv", head));
  settle();
  EXPECT_TRUE(window.messageBar()->text().contains("headonly.csv")) << window.messageBar()->text().toStdString();
}

TEST_F(HonestyTest, AMeshThatIsNotChosenYetIsNotTakenForTheShape) {
  openWith({});
  window.showStep(Step::shape);
  settle();
  click(Step::shape, "picture_box");
  click(Step::shape, "picture_mesh");
  EXPECT_EQ(window.panel(Step::shape)->state().line, "choose a CAD file");
  EXPECT_EQ(find<QPushButton>(Step::shape, "mainButton")->text(), "Choose a CAD file …");
  EXPECT_TRUE(texts(Step::shape).contains("the result uses: Box"));
}

TEST_F(HonestyTest, TheFirstWindowFitsTheScreenWithItsFrame) {
  MainWindow fresh(&workspace, false);
  const QSize room = QGuiApplication::primaryScreen()->availableSize();
  EXPECT_LT(fresh.height(), room.height());
  EXPECT_LE(fresh.minimumHeight(), room.height());
  // Down to Full HD at twice the size: the button at the foot stays on the screen.
  window.setMinimumSize(640, 400);
  window.resize(948, 496);
  settle(200);
  EXPECT_LE(window.height(), 500);
  auto* main = find<QPushButton>(Step::record, "mainButton");
  ASSERT_NE(main, nullptr);
  EXPECT_LE(main->mapTo(&window, QPoint(0, main->height())).y(), window.height());
}

TEST_F(HonestyTest, ASessionThatCannotBeSavedIsToldUntilItCan) {
  const QString state = folder.filePath("state");
  ASSERT_TRUE(writeTextFile(state.toStdString(), "a file where the folder should be"));
  Workspace other;
  Autosave autosave(&other, state, 20);
  MainWindow fresh(&other, false);
  fresh.useAutosave(&autosave);
  other.setStep("mark");
  autosave.flush();
  EXPECT_TRUE(fresh.messageBar()->text().contains("cannot be saved automatically"));
  MainWindow german(&other, false);  // As after a change of the language
  german.useAutosave(&autosave);
  EXPECT_TRUE(german.messageBar()->text().contains("cannot be saved automatically"));
  ASSERT_TRUE(QFile::remove(state));
  autosave.flush();
  EXPECT_TRUE(autosave.lastSaved().isValid());
  EXPECT_EQ(fresh.messageBar()->text() + german.messageBar()->text(), "");
}

TEST_F(HonestyTest, EachSessionThatCannotBeReadIsNamedAndWhatWasRestored) {
  openWith({});
  const QString state = folder.filePath("state");
  ASSERT_TRUE(QDir().mkpath(state));
  ASSERT_TRUE(workspace.save(state + "/autosave-999997-0.heft"));
  for (const QString name : {"autosave-999998-0.heft", "autosave-999999-0.heft"}) {
    QFile file(state + "/" + name);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    file.write("{");
    file.flush();
    ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime));
  }
  Workspace other;
  Autosave autosave(&other, state, 20);
  MainWindow fresh(&other, false);
  fresh.useAutosave(&autosave);
  fresh.messageBar()->findChild<QPushButton*>("messageAction")->click();
  const QString told = fresh.messageBar()->text();
  EXPECT_TRUE(told.startsWith("An older session was restored, saved on ")) << told.toStdString();
  EXPECT_TRUE(told.contains("unreadable-autosave-999998-0.heft") && told.contains("unreadable-autosave-999999-0.heft"))
      << told.toStdString();
  EXPECT_FALSE(told.contains("could not be restored")) << told.toStdString();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !other.busy() && other.opened(); }, 60000));
}

}  // namespace
}  // namespace heft
