#pragma once
// The mouse over a widget that shares a time axis: the wheel zooms about the pointer, with Shift it pans; a drag marks
// a band and zooms to it, with Shift or the middle button it pans; a click picks a time; a double click shows
// everything.
#include <QObject>
#include <QPoint>
#include <optional>
#include <utility>

class QMouseEvent;
class QWheelEvent;
class QWidget;

namespace heft {

class TimeAxis;

class TimeMouse : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it; the widget tracks the mouse from now on and is redrawn as it moves.
  TimeMouse(TimeAxis* axis, QWidget* widget);

  /// What the wheel does over a widget `width` pixels wide.
  static void wheel(TimeAxis* axis, QWheelEvent* event, int width);

  /// Where the pointer hovers [px]; nothing while a button is down, or elsewhere.
  std::optional<QPoint> pointer() const { return pointer_; }
  /// The band being dragged [px], left end first.
  std::optional<std::pair<int, int>> band() const;

 signals:
  void timePicked(double time);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void press(const QMouseEvent* event);
  void move(const QMouseEvent* event);
  void release(const QMouseEvent* event);

  TimeAxis* axis_;
  QWidget* widget_;
  std::optional<QPoint> pointer_;
  std::optional<int> pressed_;
  int now_ = 0;
  bool moved_ = false, pans_ = false;
  double pressedLower_ = 0.0;
};

}  // namespace heft
