#pragma once
// The recordings of the session: which one is shown, what it is called, whether they give one result together.
#include <QWidget>

namespace heft {

class Workspace;

class RecordingList : public QWidget {
  Q_OBJECT
 public:
  explicit RecordingList(Workspace* workspace, QWidget* parent = nullptr);

 signals:
  /// The user took one out of the session.
  void closed();

 private:
  void addRow(int index);
  void addTogether();
  void offer(int index, const QPoint& at);
  void askName(int index);

  Workspace* workspace_;
};

}  // namespace heft
