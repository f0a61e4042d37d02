#pragma once
// The strip under the plots: which stretches are free, contact or ignored, and the seconds below it.
#include <QWidget>
#include <vector>

#include "core/estimation/estimate.h"
#include "ui/timeline/time_axis.h"

namespace heft {

class MarksBar : public QWidget {
  Q_OBJECT
 public:
  explicit MarksBar(TimeAxis* axis, QWidget* parent = nullptr);

  void setSegments(std::vector<Segment> segments);
  const std::vector<Segment>& segments() const { return segments_; }
  /// The segment under a point of the widget, or null.
  const Segment* segmentAt(const QPoint& point) const;
  /// "contact, 13.0 – 15.3 s: a push that the motion does not explain."
  static QString describe(const Segment& segment);

  QSize sizeHint() const override { return {600, 52}; }

 signals:
  void timePicked(double time);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  TimeAxis* axis_;
  std::vector<Segment> segments_;
};

/// The word for a mark: free, contact, ignored.
QString markWord(MarkLabel label);

}  // namespace heft
