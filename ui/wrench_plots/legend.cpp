#include "ui/wrench_plots/legend.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft {

LegendEntry::LegendEntry(WrenchPlots::Shown what, const QString& text, QWidget* parent)
    : QAbstractButton(parent), what_(what) {
  setText(text);
  setCheckable(true);
  setChecked(true);
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  setToolTip(tr("Show or hide: %1").arg(text));
  setAccessibleName(tr("Show %1").arg(text));
}

int LegendEntry::sampleWidth() const { return static_cast<int>(what_) < 3 ? 12 : 26; }

void LegendEntry::setShortText(const QString& text) {
  if (short_ == text) return;
  short_ = text;
  updateGeometry();
  update();
}

int LegendEntry::widthWith(const QString& text) const {
  return sampleWidth() + 8 + QFontMetrics(uiFont(type::kCaption)).horizontalAdvance(text) + 8;
}

QSize LegendEntry::sizeHint() const { return {widthWith(shown()), 24}; }

QSize LegendEntry::minimumSizeHint() const { return sizeHint(); }

void LegendEntry::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!isChecked()) painter.setOpacity(0.4);
  const double middle = height() / 2.0;
  const QRectF sample(4, middle - 6, sampleWidth(), 12);
  const int which = static_cast<int>(what_);
  if (which < 3) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.axis[which]);
    painter.drawRoundedRect(sample, 3, 3);
  } else if (what_ == WrenchPlots::Shown::difference) {
    painter.fillRect(sample.adjusted(0, 2, 0, -2), t.noise);
    QPainterPath wave(QPointF(sample.left(), middle));
    for (double x = 1; x <= sample.width(); x += 1) wave.lineTo(sample.left() + x, middle - 2.2 * std::sin(x * 0.75));
    painter.setPen(QPen(t.text3, 1.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(wave);
  } else {
    QPen pen(t.text2, 1.7);
    if (what_ == WrenchPlots::Shown::simulated) pen.setDashPattern({3.0, 2.0});
    pen.setCapStyle(Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLine(QPointF(sample.left(), middle), QPointF(sample.right(), middle));
  }
  QFont font = uiFont(type::kCaption);
  font.setStrikeOut(!isChecked());
  painter.setFont(font);
  painter.setPen(t.text2);
  painter.drawText(QRectF(sample.right() + 8, 0, width() - sample.right() - 8, height()),
                   Qt::AlignVCenter | Qt::AlignLeft, shown());
  if (hasFocus()) {
    painter.setOpacity(1.0);
    painter.setPen(QPen(t.accent, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 2.5, -0.5, -2.5), 4, 4);
  }
}

}  // namespace heft
