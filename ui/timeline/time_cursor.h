#pragma once
// The line through plots and marks at the instant shown, drawn over them so that moving it redraws no curve.
#include <QWidget>

#include "ui/timeline/time_axis.h"

namespace heft {

class TimeCursor : public QWidget {
 public:
  /// Covers `parent`, whose children share `axis` from the parent's left edge; `bottomInset` px at the bottom stay
  /// free.
  TimeCursor(TimeAxis* axis, QWidget* parent, int bottomInset);

  void setTime(double time);
  void setShown(bool shown);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QRect dirtyRect() const;

  TimeAxis* axis_;
  int bottomInset_;
  double time_ = 0.0;
  bool shown_ = false;
};

}  // namespace heft
