#pragma once
// The table of all methods under the 3D view.
#include <QWidget>

#include "ui/models/method_table.h"

class QTableWidget;

namespace heft {

class MethodPane : public QWidget {
  Q_OBJECT
 public:
  explicit MethodPane(QWidget* parent = nullptr);
  void showTable(const MethodTable& table);
  void showWorking();

 signals:
  void closeWanted();

 private:
  QTableWidget* table_;
  QWidget* working_;
};

}  // namespace heft
