// Everything that can be operated can be operated by keyboard and found by a screen reader: names, tips, and the Tab
// key's way through every step, which goes as the eye does.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <set>

#include "core/simulation/virtual_rig.h"
#include "tests/gl/window_fixture.h"
#include "ui/record_panel/record_panel.h"

namespace heft {
namespace {

class AccessTest : public RealWindowTest {
 protected:
  AccessTest() : RealWindowTest("access") { QApplication::setActiveWindow(&window); }
  void open() {
    SimulateOptions options;
    options.motion = MotionKind::excitation;
    options.duration = 8.0;
    RealWindowTest::open(writeSimulated(folder, practiceTool(3), options));
  }

  static std::string describe(const QWidget* widget) {
    QString out = QString::fromLatin1(widget->metaObject()->className());
    if (!widget->objectName().isEmpty()) out += QStringLiteral(" \"%1\"").arg(widget->objectName());
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
      out += QStringLiteral(" [%1]").arg(button->text());
    if (!widget->toolTip().isEmpty()) out += QStringLiteral(" (%1)").arg(widget->toolTip().left(40));
    const QPoint at = widget->mapTo(widget->window(), QPoint());
    return QStringLiteral("%1 at %2,%3").arg(out).arg(at.x()).arg(at.y()).toStdString();
  }
  /// What a user works with, not the parts that Qt makes such things of.
  static bool interactive(const QWidget* widget) {
    if (!widget->isEnabled() || widget->focusProxy() || qobject_cast<const QLabel*>(widget)) return false;
    // The arrow keys of a stepper's field do what its two buttons do.
    if (widget->parentWidget()->inherits("heft::Stepper") && widget->focusPolicy() == Qt::NoFocus) return false;
    if (qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QMenuBar*>(widget)) return false;
    if (widget->inherits("QMenuBarExtension") || widget->inherits("QSplitterHandle")) return false;
    const QWidget* parent = widget->parentWidget();
    if (qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent)) return false;
    if (qobject_cast<const QLineEdit*>(parent)) return false;
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget) ||
           qobject_cast<const QAbstractSlider*>(widget) ||
           (widget->focusPolicy() != Qt::NoFocus && !qobject_cast<const QScrollArea*>(widget));
  }
  /// Only the chosen one of a group is on the Tab key's way; the arrow keys lead to the others.
  static bool reachedByArrows(const QWidget* widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    if (!button || !button->isCheckable() || button->isChecked()) return false;
    if (button->group() && button->group()->exclusive()) return button->group()->checkedButton() != nullptr;
    return button->autoExclusive();
  }
  /// The header, the steps, the view ...: the nearest ancestor that is one of the window's own parts.
  static const QWidget* regionOf(const QWidget* widget) {
    for (; widget && widget->parentWidget(); widget = widget->parentWidget())
      for (const char* part :
           {"heft::HeaderBar", "heft::StepBar", "heft::MessageBar", "heft::RobotView", "heft::RecordingPane",
            "heft::DifferencePane", "heft::StepPanel", "heft::Manual", "heft::StatusBar"})
        if (widget->inherits(part)) return widget;
    return nullptr;
  }
  static QRect place(const QWidget* widget) { return {widget->mapTo(widget->window(), QPoint()), widget->size()}; }

  void check(const char* where) {
    SCOPED_TRACE(where);
    QTest::qWait(50);
    std::vector<QWidget*> all;
    for (auto* widget : window.findChildren<QWidget*>())
      if (widget->isVisible() && widget->window() == &window && interactive(widget)) all.push_back(widget);
    EXPECT_GT(all.size(), 10u);
    for (auto* widget : all) {
      auto* accessible = QAccessible::queryAccessibleInterface(widget);
      EXPECT_TRUE(accessible && !accessible->text(QAccessible::Name).trimmed().isEmpty())
          << "no name: " << describe(widget);
      const auto* button = qobject_cast<QAbstractButton*>(widget);
      // A view is described, not tipped: a tip would stand in the picture.
      const bool view = !button && !qobject_cast<const QLineEdit*>(widget) && !qobject_cast<const QComboBox*>(widget) &&
                        !qobject_cast<const QAbstractSpinBox*>(widget);
      const bool saysItself = view || (button && !button->text().trimmed().isEmpty());
      EXPECT_TRUE(saysItself || !widget->toolTip().isEmpty()) << "no tip: " << describe(widget);
    }
    // Once round with the Tab key.
    window.setFocus();
    std::vector<QWidget*> way;
    std::set<QWidget*> seen;
    for (int k = 0; k < 400; ++k) {
      QWidget* at = QApplication::focusWidget();
      QTest::keyClick(at ? at : &window, Qt::Key_Tab);
      at = QApplication::focusWidget();
      ASSERT_NE(at, nullptr);
      if (!seen.insert(at).second && at == way.front()) break;
      way.push_back(at);
    }
    for (auto* widget : all)
      EXPECT_TRUE(seen.contains(widget) || reachedByArrows(widget)) << "Tab does not reach " << describe(widget);
    // It may have begun in the middle of a part, and ends there.
    const QWidget* first = regionOf(way.front());
    std::set<const QWidget*> left;
    const QWidget* region = nullptr;
    bool home = false;
    for (std::size_t k = 0; k < way.size(); ++k) {
      const QWidget* next = regionOf(way[k]);
      if (next != region) {
        EXPECT_FALSE(home) << "Tab comes back to where it was before " << describe(way[k]);
        home = k > 0 && next == first;
        EXPECT_TRUE(home || left.insert(next).second) << "Tab comes back to where it was: " << describe(way[k]);
        region = next;
        continue;
      }
      if (k == 0) continue;
      const QRect before = place(way[k - 1]), now = place(way[k]);
      EXPECT_FALSE(now.bottom() <= before.top())
          << "Tab goes up from " << describe(way[k - 1]) << " to " << describe(way[k]);
      const bool sameRow = now.top() < before.center().y() && now.bottom() > before.center().y();
      EXPECT_FALSE(sameRow && now.right() <= before.left())
          << "Tab goes left from " << describe(way[k - 1]) << " to " << describe(way[k]);
    }
  }
};

TEST_F(AccessTest, BeforeAnythingIsOpen) {
  check("files");
  auto* panel = dynamic_cast<RecordPanel*>(window.panel(Step::record));
  panel->setWay(RecordPanel::Way::live);
  check("live form");
  panel->setWay(RecordPanel::Way::virtualArm);
  check("virtual arm");
  ASSERT_TRUE(panel->obey({"live", "virtual", "4", "3"})->ok());
  settle();
  check("recording");
  ASSERT_TRUE(panel->obey({"live", "discard"})->ok());
  settle();
  ASSERT_TRUE(panel->obey({"live", "poses", "4", "3"})->ok());
  settle();
  check("standing poses");
  ASSERT_TRUE(panel->obey({"live", "discard"})->ok());
}

TEST_F(AccessTest, EveryStepOfARecording) {
  open();
  for (const Step step : kAllSteps) {
    window.showStep(step);
    settle();
    check(stepId(step).data());
  }
  window.showManual(true);
  check("manual");
}

TEST_F(AccessTest, EveryStepWithDetailsAndAShape) {
  open();
  window.showDetails(true);
  ASSERT_TRUE(window.panel(Step::shape)->obey({"shape", "gripper"})->ok());
  settle();
  for (const Step step : kAllSteps) {
    window.showStep(step);
    settle();
    check(stepId(step).data());
  }
}

}  // namespace
}  // namespace heft
