#include "ui/timeline/overview_strip.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/theme/theme.h"
#include "ui/timeline/marks_bar.h"
#include "ui/timeline/time_axis.h"

namespace heft {

OverviewStrip::OverviewStrip(TimeAxis* axis, QWidget* parent) : QWidget(parent), axis_(axis) {
  setObjectName("overviewStrip");
  setAccessibleName(tr("Which part of the recording the plots show"));
  setToolTip(tr("The whole recording; drag the frame to see another part"));
  setFixedHeight(kHeight);
  setCursor(Qt::OpenHandCursor);
  connect(axis_, &TimeAxis::visibleChanged, this, qOverload<>(&QWidget::update));
}

void OverviewStrip::setSegments(std::vector<Segment> segments) {
  segments_ = std::move(segments);
  update();
}

void OverviewStrip::setTime(double time) {
  time_ = time;
  update();
}

double OverviewStrip::toX(double time) const {
  const double wide = std::max(1, width() - TimeAxis::kLeft - TimeAxis::kRight);
  return TimeAxis::kLeft + (time - axis_->fullLower()) / (axis_->fullUpper() - axis_->fullLower()) * wide;
}

double OverviewStrip::toTime(double x) const {
  const double wide = std::max(1, width() - TimeAxis::kLeft - TimeAxis::kRight);
  return axis_->fullLower() + (x - TimeAxis::kLeft) / wide * (axis_->fullUpper() - axis_->fullLower());
}

void OverviewStrip::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), t.panel);
  painter.setFont(uiFont(type::kTick));
  painter.setPen(t.text3);
  painter.drawText(QRect(12, 0, TimeAxis::kLeft - 16, height()), Qt::AlignLeft | Qt::AlignVCenter,
                   tr("Whole recording"));
  const QRectF bar(toX(axis_->fullLower()), 6, toX(axis_->fullUpper()) - toX(axis_->fullLower()), 8);
  painter.fillRect(bar, t.raised);
  for (const Segment& segment : segments_) {
    const double left = std::max(bar.left(), toX(segment.from)), right = std::min(bar.right(), toX(segment.to));
    painter.fillRect(QRectF(left, bar.top(), std::max(1.0, right - left), bar.height()), markColour(segment.label));
  }
  painter.setPen(QPen(t.text, 1.6));
  painter.setBrush(Qt::NoBrush);
  const double left = toX(axis_->lower()), right = std::max(left + 4.0, toX(axis_->upper()));
  painter.drawRoundedRect(QRectF(left, 3, right - left, 14), 3, 3);
  const double at = toX(time_);
  painter.setPen(QPen(t.text, 1.2));
  painter.drawLine(QPointF(at, 5), QPointF(at, 15));
}

void OverviewStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const double time = toTime(event->pos().x());
  // Beside the frame it jumps there first.
  if (time < axis_->lower() || time > axis_->upper())
    axis_->show(time - 0.5 * axis_->span(), time + 0.5 * axis_->span());
  grabbed_ = time - axis_->lower();
  setCursor(Qt::ClosedHandCursor);
}

void OverviewStrip::mouseMoveEvent(QMouseEvent* event) {
  if (!grabbed_) return;
  const double lower = toTime(event->pos().x()) - *grabbed_;
  axis_->show(lower, lower + axis_->span());
}

void OverviewStrip::mouseReleaseEvent(QMouseEvent*) {
  grabbed_.reset();
  setCursor(Qt::OpenHandCursor);
}

}  // namespace heft
