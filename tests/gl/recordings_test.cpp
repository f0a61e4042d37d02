// In the real window: the list of the session's recordings, the tour, errors of the live form, units, practice.
#include <QAction>
#include <QCheckBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QUndoStack>

#include "tests/gl/window_fixture.h"
#include "ui/main_window/tour.h"

namespace heft {
namespace {

class RecordingsTest : public RealWindowTest {
 protected:
  RecordingsTest() : RealWindowTest("recordings") {}
  QString simulated(const char* name, std::uint64_t seed) {
    SimulateOptions options;
    options.duration = 6.0;
    options.rateHz = 200.0;
    options.seed = seed;
    Payload tool;
    tool.mass = 0.8;
    tool.com = {0.005, -0.01, 0.06};
    tool.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
    const auto made = simulate(RobotModel::panda(), tool, options);
    EXPECT_TRUE(made.ok());
    const QString path = folder.filePath(name);
    EXPECT_TRUE(writeRecording(made->recording, path.toStdString()).ok());
    return path;
  }
  template <class T>
  T* part(const char* name) {
    for (T* each : window.findChildren<T*>(name))
      if (each->isVisible()) return each;
    return nullptr;
  }
  /// An entry of the menu behind a recording's three dots.
  void choose(const char* more, const char* action) {
    auto* button = part<QToolButton>(more);
    ASSERT_NE(button, nullptr) << more;
    QTest::mouseClick(button, Qt::LeftButton);
    auto* menu = part<QMenu>("recordingMenu");
    ASSERT_NE(menu, nullptr);
    auto* entry = menu->findChild<QAction*>(action);
    ASSERT_NE(entry, nullptr) << action;
    entry->trigger();
    menu->close();
    QTest::qWait(50);
  }
  QString panelText() {
    QString all;
    for (const auto* label : window.panel(window.step())->findChildren<QLabel*>())
      if (label->isVisible()) all += label->text() + '\n';
    return all;
  }
};

TEST_F(RecordingsTest, AreRenamedJoinedAndClosedByMouse) {
  open(simulated("a.csv", 1));
  open(simulated("b.csv", 2));
  window.showStep(Step::record);
  settle();
  choose("recordingMore0", "renameRecording");
  auto* dialog = part<QInputDialog>("renameDialog");
  ASSERT_NE(dialog, nullptr);
  dialog->setTextValue("first try");
  dialog->accept();
  QTest::qWait(50);
  ASSERT_NE(part<QPushButton>("recording0"), nullptr);
  EXPECT_TRUE(part<QPushButton>("recording0")->text().startsWith("first try"));
  EXPECT_EQ(window.step(), Step::record) << "a new name leads nowhere else";

  QTest::mouseClick(part<QCheckBox>("joinRecordings"), Qt::LeftButton, {}, QPoint(8, 20));
  settle();
  ASSERT_TRUE(workspace.session().joined);
  window.showStep(Step::result);
  settle();
  EXPECT_TRUE(panelText().contains("Joint result from 2 recordings")) << panelText().toStdString();

  window.showStep(Step::record);
  settle();
  choose("recordingMore1", "closeRecording");
  settle();
  EXPECT_EQ(workspace.session().recordings.size(), 1u);
  EXPECT_EQ(window.step(), Step::record);
  EXPECT_EQ(part<QCheckBox>("joinRecordings"), nullptr) << "one recording has nothing to be joined with";
  EXPECT_TRUE(window.windowTitle().startsWith("first try"));
  workspace.undoStack()->undo();
  settle();
  EXPECT_EQ(workspace.session().recordings.size(), 2u);
}

TEST_F(RecordingsTest, TheTourLeadsThroughAllSteps) {
  auto* start = part<QPushButton>("tourButton");
  ASSERT_NE(start, nullptr);
  QTest::mouseClick(start, Qt::LeftButton);
  settle();
  ASSERT_TRUE(workspace.report());
  EXPECT_EQ(window.step(), Step::record) << "the tour begins there and does not jump";
  auto* tour = window.findChild<Tour*>("tour");
  ASSERT_TRUE(tour->isVisible());
  QStringList said;
  for (const Step step : kAllSteps) {
    EXPECT_EQ(window.step(), step);
    said << tour->findChild<QLabel*>("messageText")->text();
    QTest::mouseClick(part<QPushButton>("tourNext"), Qt::LeftButton);
    settle();
  }
  said.removeDuplicates();
  EXPECT_EQ(said.size(), 6) << "each step has words of its own";
  EXPECT_FALSE(tour->isVisible());
}

TEST_F(RecordingsTest, WhatTheLiveFormLacksIsSaidAtItsField) {
  QTest::mouseClick(part<QPushButton>("wayLive"), Qt::LeftButton);
  QTest::qWait(50);
  QTest::mouseClick(part<QPushButton>("mainButton"), Qt::LeftButton);
  QTest::qWait(50);
  auto* address = part<QLineEdit>("sourceAddress");
  auto* error = part<QLabel>("fieldError");
  ASSERT_TRUE(address && error);
  EXPECT_TRUE(address->property("wrong").toBool());
  EXPECT_EQ(window.focusWidget(), address);
  const int below = error->mapTo(&window, QPoint()).y() - address->mapTo(&window, QPoint(0, address->height())).y();
  EXPECT_GE(below, 0);
  EXPECT_LT(below, 20) << "at the field, not elsewhere";
  QTest::keyClicks(address, "192.168.1.1");
  EXPECT_EQ(part<QLabel>("fieldError"), nullptr) << "who mends it is not scolded on";
}

TEST_F(RecordingsTest, TabsOfRecordStayUnderThePointer) {
  std::vector<int> tops;
  for (const char* way : {"wayFiles", "wayLive", "wayVirtual"}) {
    QTest::mouseClick(part<QPushButton>(way), Qt::LeftButton);
    QTest::qWait(100);
    tops.push_back(part<QPushButton>("wayLive")->mapTo(&window, QPoint()).y());
  }
  EXPECT_EQ(tops[0], tops[1]);
  EXPECT_EQ(tops[0], tops[2]);
}

TEST_F(RecordingsTest, ButtonsOfThePanelsAreLargeEnoughForAFinger) {
  open(simulated("a.csv", 1));
  for (const Step step : {Step::record, Step::mark, Step::result, Step::exportFile}) {
    window.showStep(step);
    settle();
    const auto* content = window.panel(step)->findChild<QWidget*>("panelContent");
    ASSERT_NE(content, nullptr);
    for (const auto* button : content->findChildren<QPushButton*>())
      if (button->isVisible()) {
        EXPECT_GE(button->height(), 40) << stepId(step) << ": " << button->text().toStdString();
      }
  }
}

}  // namespace
}  // namespace heft
