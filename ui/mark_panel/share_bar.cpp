#include "ui/mark_panel/share_bar.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/theme/theme.h"
#include "ui/timeline/marks_bar.h"

namespace heft {

ShareBar::ShareBar(QWidget* parent) : QWidget(parent) { setFixedHeight(12); }

void ShareBar::setSeconds(const std::array<double, 3>& seconds) {
  seconds_ = seconds;
  update();
}

void ShareBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath shape;
  shape.addRoundedRect(rect(), 4, 4);
  painter.setClipPath(shape);
  painter.fillRect(rect(), theme().quietTint);
  const double total = seconds_[0] + seconds_[1] + seconds_[2];
  if (total <= 0) return;
  double left = 0;
  for (std::size_t k = 0; k < seconds_.size(); ++k) {
    const double wide = seconds_[k] / total * width();
    painter.fillRect(QRectF(left, 0, wide, height()), markColour(static_cast<MarkLabel>(k)));
    left += wide;
  }
}

ConfidenceBar::ConfidenceBar(double value, QWidget* parent) : QWidget(parent), value_(value) { setFixedSize(68, 8); }

void ConfidenceBar::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(t.quietTint);
  painter.drawRoundedRect(rect(), 4, 4);
  painter.setBrush(t.text2);
  painter.drawRoundedRect(QRectF(0, 0, std::max(8.0, value_ * width()), height()), 4, 4);
}

}  // namespace heft
