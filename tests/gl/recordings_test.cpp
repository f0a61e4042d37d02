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

#include "core/collision/room.h"
#include "tests/gl/window_fixture.h"
#include "ui/main_window/panels.h"
#include "ui/main_window/tour.h"

namespace heft {
namespace {

const Payload kTool{0.8, {0.005, -0.01, 0.06}, Vector3d(0.0021, 0.0019, 0.0012).asDiagonal().toDenseMatrix()};

class RecordingsTest : public RealWindowTest {
 protected:
  RecordingsTest() : RealWindowTest("recordings") {}
  QString simulated(const char* name, std::uint64_t seed) {
    SimulateOptions options;
    options.duration = 6.0;
    options.rateHz = 200.0;
    options.seed = seed;
    const auto made = simulate(RobotModel::panda(), kTool, options);
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

TEST_F(RecordingsTest, WhatTheHelpSaysOfScriptsIsObeyed) {
  const ScriptForms forms = panelScriptForms();
  EXPECT_GT(forms.size(), 15u);
  for (const auto& each : forms)
    for (const QString& form : QString::fromUtf8(each.form.data(), static_cast<int>(each.form.size())).split(" | ")) {
      QStringList words;
      for (const QString& word : form.split(' ')) {
        if (word.startsWith('[') || word == "...") break;
        words << (word == word.toUpper() ? QStringLiteral("1") : word.section('|', 0, 0));
      }
      bool known = false;
      for (const Step step : kAllSteps)
        if (const auto obeyed = window.panel(step)->obey(words)) known = true;
      EXPECT_TRUE(known) << form.toStdString();
      settle(0);
    }
}

TEST_F(RecordingsTest, WallsThatTheToolTouchedBecomeTheRoom) {
  SimulateOptions options;
  options.motion = MotionKind::pickAndPlace;
  options.seed = 3;
  options.duration = 15.0;
  options.rateHz = 200.0;
  open(writeSimulated(folder, kTool, options));
  window.showStep(Step::record);
  settle();
  auto* button = part<QPushButton>("roomFromTouches");
  ASSERT_NE(button, nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
  settle();
  EXPECT_TRUE(workspace.session().room.empty()) << "where the tool ends is not known yet";

  ShapeChoice pin;
  pin.answer = ShapeChoice::Answer::given;
  pin.shape = parseShape("cylinder:0.01,0.15@0,0,0.075").value();
  workspace.setShape(pin, "pin");
  settle();
  button = part<QPushButton>("roomFromTouches");
  ASSERT_NE(button, nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
  settle();
  const auto file = workspace.session().room;
  ASSERT_EQ(file.filename(), "simulated.room.json");
  const auto room = readRoom(file);
  ASSERT_TRUE(room.ok());
  EXPECT_GE(room->obstacles.size(), 1u);
  EXPECT_TRUE(panelText().contains("simulated.room.json"));
  // A second look replaces no file.
  ASSERT_TRUE(window.panel(Step::record)->obey({"room", "touched"})->ok());
  settle();
  EXPECT_EQ(workspace.session().room.filename(), "simulated.room-2.json");
  keepPicture(window, "recordings-touched");
  workspace.undoStack()->undo();
  workspace.undoStack()->undo();
  EXPECT_TRUE(workspace.session().room.empty());
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
