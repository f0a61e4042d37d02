#include "ui/timeline/time_cursor.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/theme/theme.h"

namespace heft {

TimeCursor::TimeCursor(TimeAxis* axis, QWidget* parent, int bottomInset)
    : QWidget(parent), axis_(axis), bottomInset_(bottomInset) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  parent->installEventFilter(this);
  setGeometry(parent->rect());
  connect(axis_, &TimeAxis::visibleChanged, this, [this] { update(); });
}

void TimeCursor::setTime(double time) {
  if (time == time_) return;
  update(dirtyRect());
  time_ = time;
  update(dirtyRect());
}

void TimeCursor::setShown(bool shown) {
  shown_ = shown;
  update();
}

QRect TimeCursor::dirtyRect() const {
  const int x = static_cast<int>(std::lround(axis_->toX(time_, width())));
  return {x - 100, 0, 200, height()};
}

bool TimeCursor::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) {
    setGeometry(parentWidget()->rect());
    raise();
  }
  return QWidget::eventFilter(watched, event);
}

void TimeCursor::paintEvent(QPaintEvent*) {
  if (!shown_ || time_ < axis_->lower() || time_ > axis_->upper()) return;
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double x = std::round(axis_->toX(time_, width())) + 0.5;
  painter.setPen(QPen(t.text, 1.4));
  painter.drawLine(QPointF(x, 2), QPointF(x, height() - bottomInset_));
  QPainterPath head;
  head.moveTo(x - 6, 0);
  head.lineTo(x + 6, 0);
  head.lineTo(x, 7);
  head.closeSubpath();
  painter.fillPath(head, t.text);

  painter.setFont(uiFont(type::kCaption, QFont::DemiBold));
  const QString text = timeText(time_, axis_->poses());
  const double labelWidth = painter.fontMetrics().horizontalAdvance(text) + 20;
  double left = x + 8;
  if (left + labelWidth > width() - 4) left = x - 8 - labelWidth;
  // Where the marks bar stands alone, its words stay free.
  constexpr int kHigh = 20, kLow = 80;  // [px]
  const QRectF label(left, height() < kLow ? height() - kHigh : 5, labelWidth, kHigh);
  painter.setPen(Qt::NoPen);
  painter.setBrush(t.text);
  painter.drawRoundedRect(label, 4, 4);
  painter.setPen(t.panel);
  painter.drawText(label, Qt::AlignCenter, text);
}

}  // namespace heft
