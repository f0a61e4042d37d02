#pragma once
// The obstacles around the arm, as a row on the page of Record.
#include <QWidget>

class QLabel;
class QPushButton;

namespace heft {

struct Room;
class Workspace;

class RoomRow : public QWidget {
  Q_OBJECT
 public:
  RoomRow(Workspace* workspace, QWidget* parent);

 signals:
  void chooseWanted();
  /// From walls that the tool touched in the shown recording.
  void touchedWanted();

 private:
  void refresh();

  Workspace* workspace_;
  QLabel* words_;
  QPushButton *choose_, *touched_, *remove_;
};

/// "workshop.json: 3 obstacles, nothing comes nearer than 20 mm"
QString roomText(const QString& file, const Room& room);

}  // namespace heft
