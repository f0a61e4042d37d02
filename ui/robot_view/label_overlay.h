#pragma once
// Names of what the 3D view shows: labels in the free column at the right, joined to their points by thin leaders.
#include <QPointF>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <array>
#include <functional>
#include <vector>

#include "ui/robot_view/label_layout.h"

namespace heft {

struct ViewLabel {
  QPointF anchor;  ///< In widget pixels
  QString title;
  QString note;  ///< Second line; may be empty
};

class LabelOverlay : public QWidget {
 public:
  explicit LabelOverlay(QWidget* parent);

  /// What they keep clear of; the picture is the overlay's own size.
  void setLabels(std::vector<ViewLabel> labels, LabelRoom room);
  /// Little circled letters at the ends of the sensor's axes; a point outside the widget hides its letter.
  void setAxisLetters(const std::array<QPointF, 3>& ends, bool shown);

  /// What else is painted, under the labels.
  void setUnderlay(std::function<void(QPainter&)> paint) { underlay_ = std::move(paint); }

  /// Where the labels stand, in the order of the anchors' height.
  const std::vector<QRectF>& placed() const { return places_; }
  QStringList titles() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<ViewLabel> labels_;
  std::vector<QRectF> places_;
  LabelSide side_ = LabelSide::right;
  std::array<QPointF, 3> axisEnds_;
  bool axesShown_ = false;
  std::function<void(QPainter&)> underlay_;
};

}  // namespace heft
