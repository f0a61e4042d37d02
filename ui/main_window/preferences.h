#pragma once
// Language, theme, where recordings go, and which keys do what, in one dialog.
#include <QDialog>

#include "ui/models/units.h"
#include "ui/theme/theme.h"

class QComboBox;
class QLineEdit;
class QMenuBar;

namespace heft {

class Preferences : public QDialog {
  Q_OBJECT
 public:
  struct Choice {
    QString language;  ///< Code
    ThemeKind theme = ThemeKind::light;
    QString folder;  ///< For recordings made in the program
    UnitChoice units;
  };
  /// `languages`: code and its own name each. The keys are those of the menus in `bar`, and of the window.
  Preferences(const Choice& now, const QList<QPair<QString, QString>>& languages, const QMenuBar* bar,
              QWidget* parent = nullptr);
  /// Valid once it was accepted.
  Choice choice() const;

 private:
  QWidget* makeKeys(const QMenuBar* bar);

  QComboBox* language_;
  QComboBox* theme_;
  QLineEdit* folder_;
  QComboBox *mass_, *length_, *torque_, *angle_;
};

}  // namespace heft
