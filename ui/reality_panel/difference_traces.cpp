#include "ui/reality_panel/difference_traces.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/charts/chart.h"
#include "ui/models/numbers.h"
#include "ui/theme/theme.h"
#include "ui/timeline/time_mouse.h"

namespace heft {
namespace {

constexpr int kTicks = 20;  ///< [px] below the lanes
constexpr int kGap = 8;     ///< [px] between them
constexpr int kTop = 8;     ///< [px]

int decimalsOf(const std::vector<double>& ticks) {
  if (ticks.size() < 2) return 2;
  const double step = ticks[1] - ticks[0];
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
}

}  // namespace

double DifferenceCurves::value(int curve, int at) const {
  switch (curve) {
    case 0:
      return measured[at];
    case 1:
      return without[at];
    case 2:
      return with[at];
    case 3:
      return measured[at] - without[at];
    case 4:
      return measured[at] - with[at];
    default:
      return clean.isEmpty() ? std::nan("") : curve == 5 ? clean[at] : measured[at] - clean[at];
  }
}

DifferenceTraces::DifferenceTraces(TimeAxis* axis, QWidget* parent)
    : QWidget(parent), axis_(axis), mouse_(new TimeMouse(axis, this)) {
  setObjectName("differenceTraces");
  setAccessibleName(tr("Measured and simulated, without and with the causes, and the residual"));
  setMinimumHeight(110);
  connect(mouse_, &TimeMouse::timePicked, this, &DifferenceTraces::timePicked);
  connect(axis_, &TimeAxis::visibleChanged, this, [this] { update(); });
}

void DifferenceTraces::setCurves(DifferenceCurves curves) {
  curves_ = std::move(curves);
  update();
}

void DifferenceTraces::setTime(double time) {
  time_ = time;
  update();
}

std::array<int, 2> DifferenceTraces::visible() const {
  const auto& t = curves_.time;
  const auto first = std::lower_bound(t.begin(), t.end(), axis_->lower());
  const auto last = std::upper_bound(first, t.end(), axis_->upper());
  return {std::max(0, static_cast<int>(first - t.begin()) - 1),
          std::min(static_cast<int>(t.size()), static_cast<int>(last - t.begin()) + 1)};
}

std::array<double, 2> DifferenceTraces::rangeOf(std::initializer_list<int> curves, double least) const {
  const auto [from, to] = visible();
  double low = 1e300, high = -1e300;
  for (const int curve : curves)
    for (int i = from; i < to; ++i) {
      const double v = curves_.value(curve, i);
      if (!std::isfinite(v)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
    }
  if (!(high >= low)) return {-1.0, 1.0};
  if (least > 0.0) {
    low = std::min(low, -least);
    high = std::max(high, least);
  }
  const double pad = std::max(0.08 * (high - low), 1e-4);
  return {low - pad, high + pad};
}

std::array<double, 2> DifferenceTraces::differenceRange() const { return rangeOf({3, 4, 6}, 1.3 * curves_.noise); }

std::array<DifferenceTraces::Lane, 2> DifferenceTraces::lanes() const {
  const double left = TimeAxis::kLeft, wide = std::max(20, width() - TimeAxis::kLeft - TimeAxis::kRight);
  const double high = std::max(40, height() - kTop - kGap - kTicks);
  const auto upper = rangeOf({0, 1, 2, 5}, 0.0), lower = differenceRange();
  return {Lane{QRectF(left, kTop, wide, 0.5 * high), upper[0], upper[1]},
          Lane{QRectF(left, kTop + 0.5 * high + kGap, wide, 0.5 * high), lower[0], lower[1]}};
}

void DifferenceTraces::drawLane(QPainter& p, const Lane& lane, const QString& title) const {
  const Theme& t = theme();
  p.setFont(uiFont(type::kTick));
  const QFontMetricsF metrics(p.font());
  // One number alone says nothing of the scale.
  int wanted = lane.area.height() > 90 ? 5 : 3;
  std::vector<double> ticks = ticksBetween(lane.low, lane.high, wanted);
  while (ticks.size() < 2 && wanted < 8) ticks = ticksBetween(lane.low, lane.high, ++wanted);
  const int decimals = decimalsOf(ticks);
  for (const double tick : ticks) {
    const double y = lane.y(tick);
    if (y < lane.area.top() + 4 || y > lane.area.bottom() - 4) continue;
    p.setPen(QPen(std::abs(tick) < 1e-12 ? t.plotZero : t.plotGrid, 1));
    p.drawLine(QPointF(lane.area.left(), y), QPointF(lane.area.right(), y));
    p.setPen(t.text2);
    p.drawText(QRectF(lane.area.left() - 60, y - 8, 54, 16), Qt::AlignRight | Qt::AlignVCenter,
               numberText(tick, decimals));
  }
  p.setPen(QPen(t.line, 1));
  p.drawRect(lane.area);
  p.setFont(uiFont(type::kTick, QFont::DemiBold));  // "Drehmoment" has to fit, too.
  p.setPen(t.text);
  p.drawText(QRectF(12, lane.area.top() - 2, TimeAxis::kLeft - 46, lane.area.height() + 4),
             Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, title);
}

void DifferenceTraces::drawCurve(QPainter& p, const Lane& lane, int curve, const QPen& pen) const {
  const auto [from, to] = visible();
  QPainterPath path;
  bool open = false;
  int column = -1;
  double low = 0.0, high = 0.0;
  // Where several samples share a pixel their extremes stand for them.
  const auto flush = [&] {
    if (column < 0) return;
    const QPointF first(column, lane.y(low)), second(column, lane.y(high));
    open ? path.lineTo(first) : path.moveTo(first);
    if (high > low) path.lineTo(second);
    open = true;
    column = -1;
  };
  const bool crowded = to - from > 2 * static_cast<int>(lane.area.width());
  for (int i = from; i < to; ++i) {
    const double v = curves_.value(curve, i), x = axis_->toX(curves_.time[i], width());
    if (!std::isfinite(v)) {
      flush();
      open = false;
      continue;
    }
    if (!crowded) {
      const QPointF at(x, lane.y(v));
      open ? path.lineTo(at) : path.moveTo(at);
      open = true;
      continue;
    }
    if (const int here = static_cast<int>(x); here != column) {
      flush();
      column = here;
      low = high = v;
    }
    low = std::min(low, v);
    high = std::max(high, v);
  }
  flush();
  p.save();
  p.setClipRect(lane.area);
  p.setPen(pen);
  p.setBrush(Qt::NoBrush);
  p.drawPath(path);
  p.restore();
}

/// An arrow from the simulated curve to the measured one where the load changes fastest, as long as the delay.
void DifferenceTraces::drawDelay(QPainter& p, const Lane& lane) const {
  if (curves_.delay == 0.0) return;
  const double pixels =
      axis_->toX(axis_->lower() + std::abs(curves_.delay), width()) - axis_->toX(axis_->lower(), width());
  if (pixels < 6.0) return;  // Too short to be seen: zoomed out
  const auto [from, to] = visible();
  int best = -1;
  double steepest = 0.0;
  for (int i = from + 1; i + 1 < to; ++i) {
    const double slope = std::abs(curves_.without[i + 1] - curves_.without[i - 1]);
    const double x = axis_->toX(curves_.time[i], width());
    if (std::isfinite(slope) && slope > steepest && x > lane.area.left() + 40 && x < lane.area.right() - 90) {
      steepest = slope;
      best = i;
    }
  }
  if (best < 0) return;
  const double y = lane.y(curves_.without[best]), x = axis_->toX(curves_.time[best], width());
  const double end = x + (curves_.delay > 0.0 ? pixels : -pixels);
  p.setPen(QPen(theme().text, 2.0));
  p.drawLine(QPointF(x, y), QPointF(end, y));
  const double back = curves_.delay > 0.0 ? -5.0 : 5.0;
  p.drawLine(QPointF(end, y), QPointF(end + back, y - 4));
  p.drawLine(QPointF(end, y), QPointF(end + back, y + 4));
  const QString text = tr("%1 ms").arg(numberText(1e3 * std::abs(curves_.delay), 0));
  p.setFont(uiFont(type::kCaption, QFont::DemiBold));
  const double wide = QFontMetricsF(p.font()).horizontalAdvance(text) + 10;
  const QRectF box(std::max(x, end) + 6, y - 9, wide, 18);
  p.setPen(Qt::NoPen);
  p.setBrush(theme().text);
  p.drawRoundedRect(box, 4, 4);
  p.setPen(theme().panel);
  p.drawText(box, Qt::AlignCenter, text);
  p.setBrush(Qt::NoBrush);
}

int DifferenceTraces::nearest(double time) const {
  const auto& t = curves_.time;
  if (t.isEmpty()) return -1;
  const auto after = static_cast<int>(std::lower_bound(t.begin(), t.end(), time) - t.begin());
  if (after == 0) return 0;
  if (after == t.size()) return static_cast<int>(t.size()) - 1;
  return time - t[after - 1] < t[after] - time ? after - 1 : after;
}

void DifferenceTraces::drawPointer(QPainter& p, const std::array<Lane, 2>& lanes) const {
  const int pointer = mouse_->pointer() ? mouse_->pointer()->x() : -1;
  if (pointer < lanes[0].area.left() || pointer > lanes[0].area.right()) return;
  const int at = nearest(axis_->toTime(pointer, width()));
  if (at < 0) return;
  const Theme& t = theme();
  p.setPen(QPen(t.text3, 1, Qt::DotLine));
  p.drawLine(QPointF(pointer + 0.5, lanes[0].area.top()), QPointF(pointer + 0.5, lanes[1].area.bottom()));
  const int decimals = curves_.decimals;
  const QString names[] = {tr("measured"),      tr("without"),    tr("with the causes"), tr("residual without"),
                           tr("residual with"), tr("clean twin"), tr("the fault alone")};
  QStringList left{axis_->poses() ? tr("pose") : tr("time")},
      right{axis_->poses() ? numberText(curves_.time[at], 0) : tr("%1 s").arg(numberText(curves_.time[at], 2))};
  for (int c = 0; c < 7; ++c) {
    const double v = curves_.value(c, at);
    if (!std::isfinite(v)) continue;
    left << names[c];
    right << numberText(v, decimals) + QLatin1Char(' ') + curves_.unit;
  }
  p.setFont(uiFont(type::kCaption));
  const QFontMetricsF metrics(p.font());
  double a = 0.0, b = 0.0;
  for (int i = 0; i < left.size(); ++i) {
    a = std::max(a, metrics.horizontalAdvance(left[i]));
    b = std::max(b, metrics.horizontalAdvance(right[i]));
  }
  const double wide = a + b + 30, high = 17.0 * left.size() + 10;
  const bool leftwards = pointer + 14 + wide > lanes[0].area.right();
  const QRectF box(leftwards ? pointer - 14 - wide : pointer + 14, lanes[0].area.top() + 4, wide, high);
  QColor ground = t.panel;
  ground.setAlpha(238);
  p.setPen(QPen(t.line, 1));
  p.setBrush(ground);
  p.drawRoundedRect(box, 6, 6);
  p.setBrush(Qt::NoBrush);
  for (int i = 0; i < left.size(); ++i) {
    const QRectF row(box.left() + 8, box.top() + 5 + 17.0 * i, wide - 16, 17);
    p.setPen(t.text2);
    p.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, left[i]);
    p.setPen(t.text);
    p.drawText(row, Qt::AlignRight | Qt::AlignVCenter, right[i]);
  }
}

void DifferenceTraces::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const Theme& t = theme();
  if (curves_.time.isEmpty()) {
    p.setPen(t.text2);
    p.drawText(rect(), Qt::AlignCenter, tr("Nothing to compare yet."));
    return;
  }
  const auto both = lanes();
  const auto& [upper, lower] = both;
  if (curves_.noise > 0.0) {
    p.save();
    p.setClipRect(lower.area);
    p.fillRect(QRectF(QPointF(lower.area.left(), lower.y(curves_.noise)),
                      QPointF(lower.area.right(), lower.y(-curves_.noise))),
               t.noise);
    p.restore();
  }
  // Where it has no room beside the name, the unit stands below it in one piece.
  const QString unit = QStringLiteral(" [%1]").arg(QString(curves_.unit).replace(QLatin1Char(' '), QChar(0xA0)));
  drawLane(p, upper, curves_.channel + unit);
  drawLane(p, lower, tr("residual") + unit);
  QPen dashed(t.text2, 1.5);
  dashed.setDashPattern({3.0, 2.0});
  // Where the two agree, the measured curve covers the corrected simulation.
  drawCurve(p, upper, 2, QPen(t.accent, 3.4));
  drawCurve(p, upper, 1, dashed);
  drawCurve(p, upper, 5, QPen(t.good, 1.6));
  drawCurve(p, upper, 0, QPen(t.text, 1.4));
  drawCurve(p, lower, 3, dashed);
  drawCurve(p, lower, 4, QPen(t.accent, 1.6));
  drawCurve(p, lower, 6, QPen(t.good, 1.6));
  drawDelay(p, upper);
  p.setFont(uiFont(type::kTick));
  p.setPen(t.text2);
  const auto ticks =
      ticksBetween(axis_->lower(), axis_->upper(), std::max(2, static_cast<int>(lower.area.width() / 110)));
  const int decimals = decimalsOf(ticks);
  for (const double tick : ticks) {
    const double x = std::clamp(axis_->toX(tick, width()), lower.area.left() + 10, lower.area.right() - 14);
    p.drawText(
        QRectF(x - 40, lower.area.bottom() + 3, 80, 16), Qt::AlignCenter,
        numberText(tick, decimals) + (tick == ticks.back() && !axis_->poses() ? QStringLiteral(" s") : QString()));
  }
  if (time_ >= axis_->lower() && time_ <= axis_->upper()) {
    const double x = std::round(axis_->toX(time_, width())) + 0.5;
    p.setPen(QPen(t.text, 1.4));
    p.drawLine(QPointF(x, upper.area.top()), QPointF(x, lower.area.bottom()));
  }
  if (const auto band = mouse_->band()) {
    QColor fill = t.text2;
    fill.setAlpha(40);
    p.fillRect(
        QRectF(band->first, upper.area.top(), band->second - band->first, lower.area.bottom() - upper.area.top()),
        fill);
  } else {
    drawPointer(p, both);
  }
}

void DifferenceTraces::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace heft
