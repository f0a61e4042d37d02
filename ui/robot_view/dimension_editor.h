#pragma once
// A length in the 3D view is changed where it stands: a click on its label, or on its handle without dragging, opens a
// field in its place.
#include <QObject>
#include <QPoint>
#include <QRect>
#include <functional>
#include <optional>
#include <vector>

#include "ui/robot_view/dimension_lines.h"

class QLineEdit;

namespace heft {

class DimensionEditor : public QObject {
  Q_OBJECT
 public:
  using Placed = std::function<std::vector<PlacedDimension>()>;
  using Current = std::function<std::optional<int>()>;
  /// Watches the mouse over `view`. `placed`: the lengths as they lie there now; `current`: the handle under the
  /// pointer.
  DimensionEditor(QWidget* view, Placed placed, Current current);

  void open(int id);
  void close();

 signals:
  /// The handle's id, and the length as it was typed.
  void typed(int id, const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool viewEvent(QEvent* event);
  std::optional<int> labelAt(const QPoint& point) const;

  QWidget* view_;
  Placed placed_;
  Current current_;
  QLineEdit* field_;
  int id_ = -1;
  bool pointing_ = false;
  std::optional<QPoint> pressed_;  ///< On a handle
};

}  // namespace heft
