#include "ui/timeline/marks_bar.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/theme/theme.h"

namespace heft {
namespace {

constexpr int kBarTop = 4, kBarHeight = 22;

const QColor& markColour(MarkLabel label) {
  const Theme& t = theme();
  return label == MarkLabel::free ? t.markFree : label == MarkLabel::contact ? t.markContact : t.markIgnored;
}

/// Text on a mark: dark on the light theme's pale colours; on the dark theme only the amber one is bright.
QColor markTextColour(MarkLabel label) {
  if (!theme().dark) return label == MarkLabel::free ? QColor("#0D4A6E") : QColor("#2B2410");
  return label == MarkLabel::contact ? QColor("#1F1803") : theme().text;
}

/// 1, 2 or 5 times a power of ten, so that about `wanted` ticks fit the span.
double tickStep(double span, double wanted, bool whole) {
  const double raw = span / std::max(1.0, wanted);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double lead = raw / power;
  const double step = (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10) * power;
  return whole ? std::max(1.0, std::round(step)) : step;
}

}  // namespace

QString markWord(MarkLabel label) {
  switch (label) {
    case MarkLabel::free:
      return MarksBar::tr("free");
    case MarkLabel::contact:
      return MarksBar::tr("contact");
    case MarkLabel::ignore:
      return MarksBar::tr("ignored");
  }
  return {};
}

MarksBar::MarksBar(TimeAxis* axis, QWidget* parent) : QWidget(parent), axis_(axis) {
  setObjectName("marksBar");
  setAccessibleName(tr("Marks"));
  setAccessibleDescription(tr("Which stretches of the recording touched nothing"));
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFixedHeight(sizeHint().height());
  connect(axis_, &TimeAxis::visibleChanged, this, [this] { update(); });
}

void MarksBar::setSegments(std::vector<Segment> segments) {
  segments_ = std::move(segments);
  update();
}

const Segment* MarksBar::segmentAt(const QPoint& point) const {
  if (point.y() < kBarTop || point.y() > kBarTop + kBarHeight) return nullptr;
  if (point.x() < TimeAxis::kLeft || point.x() > width() - TimeAxis::kRight) return nullptr;
  const double time = axis_->toTime(point.x(), width());
  for (const Segment& segment : segments_) {
    if (time >= segment.from && time <= segment.to) return &segment;
  }
  return nullptr;
}

QString MarksBar::describe(const Segment& segment) {
  QString text = QStringLiteral("%1, %2 – %3 s")
                     .arg(markWord(segment.label), numberText(segment.from, 1), numberText(segment.to, 1));
  if (!segment.reason.empty()) text += QStringLiteral(": ") + QString::fromStdString(segment.reason);
  return text;
}

void MarksBar::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), t.panel);
  painter.setFont(uiFont(type::kSection, QFont::DemiBold));
  painter.setPen(t.text);
  painter.drawText(QRect(12, kBarTop, TimeAxis::kLeft - 16, kBarHeight), Qt::AlignLeft | Qt::AlignVCenter, tr("Marks"));

  const QRectF bar(TimeAxis::kLeft, kBarTop, width() - TimeAxis::kLeft - TimeAxis::kRight, kBarHeight);
  painter.setPen(Qt::NoPen);
  painter.setBrush(t.raised);
  painter.drawRoundedRect(bar, 3, 3);
  if (segments_.empty() && axis_->poses()) {
    painter.setFont(uiFont(type::kCaption));
    painter.setPen(t.text2);
    painter.drawText(bar, Qt::AlignCenter, tr("standing poses, all used"));
  }
  painter.save();
  painter.setClipRect(bar);
  painter.setFont(uiFont(type::kCaption, QFont::DemiBold));
  for (const Segment& segment : segments_) {
    const double left = std::max(axis_->toX(segment.from, width()), bar.left() - 8);
    const double right = std::min(axis_->toX(segment.to, width()), bar.right() + 8);
    if (right < bar.left() || left > bar.right()) continue;
    // A gap of one pixel between neighbours; a sliver stays visible.
    const QRectF block(left + 0.5, bar.top(), std::max(1.0, right - left - 1.0), bar.height());
    painter.setPen(Qt::NoPen);
    painter.setBrush(markColour(segment.label));
    painter.drawRoundedRect(block, 3, 3);
    const QRectF shown = block.intersected(bar);
    const QString word = markWord(segment.label);
    if (painter.fontMetrics().horizontalAdvance(word) + 10 < shown.width()) {
      painter.setPen(markTextColour(segment.label));
      painter.drawText(shown, Qt::AlignCenter, word);
    }
  }
  painter.restore();

  painter.setFont(uiFont(type::kTick));
  painter.setPen(t.text3);
  const double step = tickStep(axis_->span(), bar.width() / 75.0, axis_->poses());
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  bool first = true;
  for (double tick = std::ceil(axis_->lower() / step - 1e-9) * step; tick <= axis_->upper() + 1e-9 * step;
       tick += step) {
    const double x = axis_->toX(tick, width());
    QString text = numberText(tick, decimals);
    if (first) text = axis_->poses() ? tr("pose %1").arg(text) : text + QStringLiteral(" s");
    first = false;
    const double half = painter.fontMetrics().horizontalAdvance(text) / 2.0 + 2;
    const double centre = std::min(x, width() - half - 2);
    painter.drawText(QRectF(centre - half, kBarTop + kBarHeight + 4, 2 * half, 16), Qt::AlignCenter, text);
  }
}

void MarksBar::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit timePicked(axis_->toTime(event->pos().x(), width()));
}

void MarksBar::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) emit timePicked(axis_->toTime(event->pos().x(), width()));
}

bool MarksBar::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const Segment* segment = segmentAt(help->pos())) {
      QToolTip::showText(help->globalPos(), describe(*segment), this);
    } else {
      QToolTip::hideText();
    }
    return true;
  }
  return QWidget::event(event);
}

}  // namespace heft
