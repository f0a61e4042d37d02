#pragma once
// One sentence at the top of the window instead of a dialog in its middle.
#include <QFrame>
#include <functional>

#include "core/base/findings.h"

class QLabel;
class QPushButton;

namespace heft {

class LightIcon;

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(Severity severity, const QString& text);
  /// With a button that does something about it and closes the message.
  void showMessage(Severity severity, const QString& text, const QString& action, std::function<void()> clicked);
  QString text() const;

 private:
  LightIcon* icon_;
  QLabel* text_;
  QPushButton* action_;
  std::function<void()> clicked_;
};

}  // namespace heft
