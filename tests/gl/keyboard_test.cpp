// The whole task without a mouse: open, mark, shape, estimate, look for causes, apply, export, by Tab, arrows and
// shortcuts.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QFile>
#include <QFileDialog>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QUndoStack>
#include <set>

#include "core/simulation/virtual_rig.h"
#include "tests/gl/window_fixture.h"
#include "ui/timeline/marks_bar.h"

namespace heft {
namespace {

class KeyboardTest : public RealWindowTest {
 protected:
  KeyboardTest() : RealWindowTest("keyboard") { QApplication::setActiveWindow(&window); }

  void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    // Without a window manager nobody makes the window active again after a dialog.
    if (!QApplication::activeWindow()) QApplication::setActiveWindow(&window);
    QWidget* at = QApplication::focusWidget();
    if (!at) at = &window;
    QTest::keyClick(at, static_cast<Qt::Key>(key), modifiers);
    QApplication::processEvents();
  }
  /// Presses Tab until the control of this name has the focus; `text` tells several of one name apart.
  void tabTo(const QString& name, const QString& text = {}) {
    for (int k = 0; k < 300; ++k) {
      QWidget* at = QApplication::focusWidget();
      const auto* button = qobject_cast<QAbstractButton*>(at);
      if (at && at->objectName() == name && (text.isEmpty() || (button && button->text().trimmed() == text))) return;
      press(Qt::Key_Tab);
    }
    FAIL() << "Tab never reaches " << name.toStdString() << " " << text.toStdString();
  }
  /// In the file dialog that the next key opens: types the name and presses Enter.
  static void answerFileDialog(const QString& path) {
    auto* poll = new QTimer;
    poll->setInterval(50);
    QObject::connect(poll, &QTimer::timeout, [poll, path, turns = 0]() mutable {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (!dialog) {
        if (turns > 0) poll->deleteLater();  // It was there, and is gone.
        return;
      }
      auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
      if (++turns > 100 || !name) return dialog->reject();
      if (name->text() == path) {
        QTest::keyClick(name, Qt::Key_Return);
      } else {
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, path);
      }
    });
    poll->start();
  }
  static QString focusName() {
    return QApplication::focusWidget() ? QApplication::focusWidget()->objectName() : QString();
  }
};

TEST_F(KeyboardTest, FromOpeningToThePayloadFile) {
  SimulateOptions options;
  options.motion = MotionKind::excitation;
  options.duration = 10.0;
  options.seed = 5;
  const Payload tool = practiceTool(4);
  const QString recording = writeSimulated(folder, tool, options);

  // Open: the one filled button, pressed with Enter.
  tabTo("mainButton");
  answerFileDialog(recording);
  press(Qt::Key_Return);
  settle();
  ASSERT_TRUE(workspace.opened());
  ASSERT_TRUE(workspace.report());

  // Mark: brush 2 (contact), a stroke of Enter, arrows, Enter on the bar of marks.
  press(Qt::Key_2, Qt::AltModifier);
  ASSERT_EQ(window.step(), Step::mark);
  press(Qt::Key_2);
  for (int k = 0; k < 300 && !qobject_cast<MarksBar*>(QApplication::focusWidget()); ++k) press(Qt::Key_Tab);
  ASSERT_TRUE(qobject_cast<MarksBar*>(QApplication::focusWidget())) << "Tab never reaches the marks";
  press(Qt::Key_Home);
  press(Qt::Key_Return);
  for (int k = 0; k < 10; ++k) press(Qt::Key_Right);
  press(Qt::Key_Return);
  settle(600);
  ASSERT_FALSE(workspace.session().recordings[0].marks.empty());
  const Mark mark = workspace.session().recordings[0].marks.back();
  EXPECT_EQ(mark.label, MarkLabel::contact);
  EXPECT_NEAR(mark.to - mark.from, 1.0, 0.02);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(workspace.session().recordings[0].marks.empty());
  press(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_FALSE(workspace.session().recordings[0].marks.empty());

  // Shape: a picture.
  press(Qt::Key_3, Qt::AltModifier);
  ASSERT_EQ(window.step(), Step::shape);
  tabTo("picture_box");
  press(Qt::Key_Space);
  settle(600);
  EXPECT_EQ(workspace.session().shape.answer, ShapeChoice::Answer::given);
  EXPECT_EQ(workspace.session().shape.shape.bodies.size(), 1u);

  // Result, then the reality check.
  press(Qt::Key_4, Qt::AltModifier);
  ASSERT_TRUE(workspace.report());
  EXPECT_NEAR(workspace.report()->payload.mass, tool.mass, 0.05 * tool.mass);
  press(Qt::Key_5, Qt::AltModifier);
  settle(300);
  if (auto* look = window.panel(Step::realityCheck)->findChild<QPushButton*>("mainButton");
      look && look->text() == "Run reality check") {
    tabTo("mainButton", "Run reality check");
    press(Qt::Key_Space);
    settle();
  }

  // Export: whose tool it is, that nothing else is mounted, and save.
  press(Qt::Key_6, Qt::AltModifier);
  ASSERT_EQ(window.step(), Step::exportFile);
  bool answered = false;
  for (int k = 0; k < 300 && !answered; ++k) {
    const auto* button = qobject_cast<QAbstractButton*>(QApplication::focusWidget());
    if (button && button->text().trimmed() == "Its own tool") {
      press(Qt::Key_Space);
      answered = true;
    } else {
      press(Qt::Key_Tab);
    }
  }
  ASSERT_TRUE(answered) << "Tab never reaches the question whose tool it is";
  EXPECT_EQ(workspace.session().exporting.role, ExportChoice::Role::ownTool);
  QTest::qWait(50);
  EXPECT_FALSE(focusName().isEmpty()) << "the panel was built anew and the keyboard is nowhere";
  tabTo("mountedNothing");
  press(Qt::Key_Space);
  EXPECT_TRUE(workspace.session().exporting.mountedAnswered);
  QTest::qWait(50);
  // The box is another one than the tool: Export says so and asks for a word.
  tabTo("saveAllTheSame");
  press(Qt::Key_Space);
  QTest::qWait(50);
  tabTo("mainButton");
  const QString saved = folder.filePath("tool.json");
  answerFileDialog(saved);
  press(Qt::Key_Return);
  QFile file(saved);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_NEAR(QJsonDocument::fromJson(file.readAll()).object()["mass"].toDouble(), workspace.report()->payload.mass,
              1e-4);

  // Undo takes everything back that was said, and redo brings it again.
  const int edits = workspace.undoStack()->count();
  EXPECT_GE(edits, 4);
  for (int k = 0; k < edits; ++k) press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(workspace.session().recordings[0].marks.empty());
  EXPECT_NE(workspace.session().shape.answer, ShapeChoice::Answer::given);
  EXPECT_EQ(workspace.session().exporting.role, ExportChoice::Role::unasked);
  for (int k = 0; k < edits; ++k) press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(workspace.session().shape.answer, ShapeChoice::Answer::given);
  EXPECT_EQ(workspace.session().exporting.role, ExportChoice::Role::ownTool);
}

TEST_F(KeyboardTest, ACauseIsAppliedAndTheKeyboardStaysThere) {
  SimulateOptions options;
  options.motion = MotionKind::excitation;
  options.seed = 4;
  options.effects = {{"cable_pull", "", 15.0}};
  open(writeSimulated(folder, practiceTool(6), options));
  press(Qt::Key_5, Qt::AltModifier);
  settle(300);
  const auto* main = window.panel(Step::realityCheck)->findChild<QPushButton*>("mainButton");
  if (main && main->text() == "Run reality check") {
    tabTo("mainButton", "Run reality check");
    press(Qt::Key_Return);
    settle();
  }
  tabTo("mainButton", "Apply this correction");
  press(Qt::Key_Space);
  settle(400);
  EXPECT_EQ(workspace.corrections().causes.size(), 1u);
  ASSERT_TRUE(QApplication::focusWidget());
  EXPECT_TRUE(window.panel(Step::realityCheck)->isAncestorOf(QApplication::focusWidget()))
      << "the keyboard left the panel";
  tabTo("plainButton", "Undo");
  press(Qt::Key_Space);
  settle(400);
  EXPECT_TRUE(workspace.corrections().causes.empty());
}

/// Where the keyboard is can be seen: a control looks different with it.
TEST_F(KeyboardTest, TheFocusIsVisibleOnEveryControl) {
  SimulateOptions options;
  options.duration = 8.0;
  open(writeSimulated(folder, practiceTool(3), options));
  ASSERT_TRUE(window.panel(Step::shape)->obey({"shape", "gripper"})->ok());
  settle();
  for (const Step step : kAllSteps) {
    window.showStep(step);
    settle();
    SCOPED_TRACE(stepId(step).data());
    std::set<QWidget*> seen;
    for (int k = 0; k < 300; ++k) {
      press(Qt::Key_Tab);
      QWidget* at = QApplication::focusWidget();
      ASSERT_NE(at, nullptr);
      if (!seen.insert(at).second) break;
      if (at->objectName() == "viewport")
        continue;  // A picture as large as half the window: its corner marks are tested by eye.
      // Round it, too: some controls leave the ring to a frame.
      QWidget* shown =
          at->parentWidget() && at->parentWidget()->size().width() < 2 * at->width() ? at->parentWidget() : at;
      const QImage with = shown->grab().toImage();
      at->clearFocus();
      QApplication::processEvents();
      const QImage without = shown->grab().toImage();
      EXPECT_NE(with, without) << "no sign of the focus on " << at->metaObject()->className() << " \""
                               << at->objectName().toStdString() << "\" " << at->accessibleName().toStdString();
      at->setFocus(Qt::TabFocusReason);
    }
    EXPECT_GT(seen.size(), 10u);
  }
}

}  // namespace
}  // namespace heft
