#include "ui/results/mass_scale.h"

#include <QPainter>
#include <algorithm>

#include "ui/theme/theme.h"

namespace heft {

MassScaleWidget::MassScaleWidget(const MassScale& scale, Source source, QWidget* parent)
    : QWidget(parent), scale_(scale), source_(source) {
  setFixedHeight(sizeHint().height());
  setAccessibleName(QStringLiteral("%1 – %2").arg(scale.lowest, scale.highest));
}

void MassScaleWidget::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double left = 6, right = width() - 6, middle = 10;
  const auto x = [&](double share) { return left + share * (right - left); };
  painter.setPen(QPen(t.line, 2));
  painter.drawLine(QPointF(left, middle), QPointF(right, middle));
  const QColor colour = source_ == Source::data                                  ? t.good
                        : source_ == Source::doubted || source_ == Source::prior ? t.look
                                                                                 : t.text3;
  QColor pale = colour;
  pale.setAlpha(115);
  const double from = x(scale_.from), to = std::max(x(scale_.to), x(scale_.from) + 3);
  painter.setPen(Qt::NoPen);
  painter.setBrush(pale);
  painter.drawRoundedRect(QRectF(from, middle - 4, to - from, 8), 2, 2);
  painter.setBrush(colour);
  painter.setPen(QPen(t.panel, 1.5));
  painter.drawEllipse(QPointF(x(scale_.value), middle), 5, 5);
  if (scale_.stated >= 0) {
    painter.setPen(QPen(t.text, 1.8));
    const double s = x(scale_.stated);
    painter.drawLine(QPointF(s, middle - 9), QPointF(s, middle + 9));
    painter.drawLine(QPointF(s - 3.5, middle - 9), QPointF(s + 3.5, middle - 9));
  }
  painter.setFont(uiFont(type::kTick));
  painter.setPen(t.text3);
  painter.drawText(QRectF(0, 19, width(), 15), Qt::AlignLeft | Qt::AlignVCenter, scale_.lowest);
  painter.drawText(QRectF(0, 19, width(), 15), Qt::AlignRight | Qt::AlignVCenter, scale_.highest);
}

}  // namespace heft
