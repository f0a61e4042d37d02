#pragma once
// While the plots show a part only: the whole recording as a thin strip, with a frame about the part, which is dragged.
#include <QWidget>
#include <optional>
#include <vector>

#include "core/estimation/estimate.h"

namespace heft {

class TimeAxis;

class OverviewStrip : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kHeight = 20;  ///< [px]

  /// `axis` must outlive it. Has nothing to say while everything is shown.
  explicit OverviewStrip(TimeAxis* axis, QWidget* parent = nullptr);
  void setSegments(std::vector<Segment> segments);
  void setTime(double time);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  double toX(double time) const;
  double toTime(double x) const;

  TimeAxis* axis_;
  std::vector<Segment> segments_;
  double time_ = 0.0;
  std::optional<double> grabbed_;  ///< Where in the frame it was caught [s from its left end]
};

}  // namespace heft
