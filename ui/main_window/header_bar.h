#pragma once
// The top of the window: name, menus, the open file, undo and redo, Simple or Details.
#include <QWidget>

class QLabel;
class QMenuBar;
class QPushButton;
class QUndoStack;

namespace heft {

class HeaderBar : public QWidget {
  Q_OBJECT
 public:
  explicit HeaderBar(QUndoStack* undo, QWidget* parent = nullptr);
  QMenuBar* menuBar() { return menus_; }
  void setDetails(bool shown);
  void setFileName(const QString& name, const QString& path);

 signals:
  void detailsWanted(bool details);

 private:
  void placeFileName();
  void resizeEvent(QResizeEvent* event) override;

  QMenuBar* menus_;
  QWidget* undo_;  ///< Where the buttons at the right begin.
  QLabel* file_;
  QString name_;  ///< In full; the label may hold less of it.
  QPushButton* simple_;
  QPushButton* details_;
};

}  // namespace heft
