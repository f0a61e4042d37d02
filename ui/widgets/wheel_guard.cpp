#include "ui/widgets/wheel_guard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>
#include <QTabBar>

namespace heft {
namespace {

class WheelGuard : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Wheel || !watched->isWidgetType()) return false;
    // Up to the window: the list that a combo box opens is one of its own and scrolls.
    for (QWidget* each = static_cast<QWidget*>(watched); each && !each->isWindow(); each = each->parentWidget()) {
      const bool holdsValue = qobject_cast<QComboBox*>(each) || qobject_cast<QAbstractSpinBox*>(each) ||
                              qobject_cast<QTabBar*>(each) ||
                              (qobject_cast<QAbstractSlider*>(each) && !qobject_cast<QScrollBar*>(each));
      if (!holdsValue) continue;
      event->ignore();  // So that what scrolls around it gets it.
      return true;
    }
    return false;
  }
};

}  // namespace

void guardWheel() {
  static const QString kName = QStringLiteral("heftWheelGuard");
  if (qApp->findChild<QObject*>(kName, Qt::FindDirectChildrenOnly)) return;
  auto* guard = new WheelGuard(qApp);
  guard->setObjectName(kName);
  qApp->installEventFilter(guard);
}

}  // namespace heft
