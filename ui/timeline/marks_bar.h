#pragma once
// The strip under the plots: which segments are free, contact or ignored, and the seconds below it. With a brush,
// labels are painted: by dragging, by dragging an edge between two segments, or by keys (Enter, arrows, Enter).
#include <QWidget>
#include <optional>
#include <vector>

#include "core/estimation/estimate.h"
#include "ui/timeline/time_axis.h"

namespace heft {

class MarksBar : public QWidget {
  Q_OBJECT
 public:
  explicit MarksBar(TimeAxis* axis, QWidget* parent = nullptr);

  /// `suggested` ones, as many as segments or none, are hatched with a question mark.
  void setSegments(std::vector<Segment> segments, std::vector<bool> suggested = {});
  const std::vector<Segment>& segments() const { return segments_; }
  /// The segment under a point of the widget, or null.
  const Segment* segmentAt(const QPoint& point) const;
  /// "contact, 13.0 – 15.3 s: a push that the motion does not explain."
  static QString describe(const Segment& segment);

  void setBrush(std::optional<MarkLabel> brush);
  /// Outlines a segment as selected.
  void setSelected(std::optional<std::pair<double, double>> stretch);
  /// The instant shown, where a stroke by keys begins and ends.
  void setTime(double time);
  bool strokeByKeys() const { return keyStroke_.has_value(); }

  QSize sizeHint() const override { return {600, 52}; }

 signals:
  void timePicked(double time);
  /// A stroke or a moved edge, earlier end first.
  void painted(double from, double to, heft::MarkLabel label);
  void brushPicked(heft::MarkLabel label);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  /// What a stroke or a dragged edge would paint now.
  struct Stroke {
    double from, to;
    MarkLabel label;
  };
  std::optional<Stroke> stroke() const;
  /// Index of the segment whose end is under x, or -1.
  int edgeAt(int x) const;
  void paintSegment(QPainter& painter, const QRectF& bar, std::size_t index) const;
  void paintWord(QPainter& painter, const QRectF& shown, MarkLabel label, bool suggested) const;
  void paintTicks(QPainter& painter, const QRectF& bar) const;
  void finishStroke();

  TimeAxis* axis_;
  std::vector<Segment> segments_;
  std::vector<bool> suggested_;
  std::optional<MarkLabel> brush_;
  std::optional<std::pair<double, double>> selected_;
  std::optional<double> pressed_;    ///< Where a stroke of the mouse began.
  std::optional<double> keyStroke_;  ///< Where one by keys began.
  int edge_ = -1;                    ///< Segment whose end is being dragged.
  double pointer_ = 0.0, time_ = 0.0;
};

/// The word for a mark: free, contact, ignored.
QString markWord(MarkLabel label);
/// Its colour in the current theme.
const QColor& markColour(MarkLabel label);

}  // namespace heft
