#pragma once
// One sentence at the top of the window instead of a dialog in its middle.
#include <QFrame>

#include "core/base/findings.h"

class QLabel;

namespace heft {

class LightIcon;

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(Severity severity, const QString& text);
  QString text() const;

 private:
  LightIcon* icon_;
  QLabel* text_;
};

}  // namespace heft
