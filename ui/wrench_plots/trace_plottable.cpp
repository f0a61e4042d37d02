#include "ui/wrench_plots/trace_plottable.h"

#include <algorithm>
#include <cmath>

#include "ui/wrench_plots/trace_raster.h"

namespace heft {
namespace {

constexpr double kDash = 6.0, kGap = 4.5;  // [px]

/// Axis coordinates to pixels of a picture; linear, and looked up once instead of per point.
struct Scale {
  double offset, slope;
  Scale(const QCPAxis* axis, double corner, double ratio) {
    const QCPRange range = axis->range();
    const double first = axis->coordToPixel(range.lower), last = axis->coordToPixel(range.upper);
    slope = ratio * (last - first) / range.size();
    offset = ratio * (first - corner) - slope * range.lower;
  }
  double operator()(double value) const { return offset + slope * value; }
};

void addCurve(TraceColumns& columns, const ThinnedCurve& curve, const Scale& x, const Scale& y) {
  constexpr double kFlat = 1.5;  // [px] Lower than this, what a column reaches is a line.
  for (int i = 0; i < curve.x.size(); ++i) {
    const double at = x(curve.x[i]), low = y(curve.low[i]), high = y(curve.high[i]);
    // A gap in the numbers is a gap in the line.
    if (!std::isfinite(low) || !std::isfinite(high)) continue;
    if (i > 0 && std::isfinite(curve.low[i - 1]))
      columns.addLine(x(curve.x[i - 1]), 0.5 * (y(curve.low[i - 1]) + y(curve.high[i - 1])), at, 0.5 * (low + high));
    if (curve.crowded && low - high > kFlat) {
      // Half way to the neighbours.
      const double half = 0.5 * x.slope * curve.step;
      columns.addBar(at - half, at + half, high, low);
    }
  }
}

}  // namespace

TracePlottable::TracePlottable(QCPAxis* keyAxis, QCPAxis* valueAxis) : QCPAbstractPlottable(keyAxis, valueAxis) {}

QCPRange TracePlottable::getKeyRange(bool& found, QCP::SignDomain) const {
  QCPRange all;
  found = false;
  for (const Trace& trace : traces_) {
    if (trace.curve.x.isEmpty()) continue;
    const QCPRange range(trace.curve.x.front(), trace.curve.x.back());
    if (found)
      all.expand(range);
    else
      all = range;
    found = true;
  }
  return all;
}

QCPRange TracePlottable::getValueRange(bool& found, QCP::SignDomain, const QCPRange&) const {
  QCPRange all;
  found = false;
  for (const Trace& trace : traces_) {
    for (int i = 0; i < trace.curve.x.size(); ++i) {
      if (!std::isfinite(trace.curve.low[i])) continue;
      const QCPRange range(trace.curve.low[i], trace.curve.high[i]);
      if (found)
        all.expand(range);
      else
        all = range;
      found = true;
    }
  }
  return all;
}

void TracePlottable::draw(QCPPainter* painter) {
  const QRect area = keyAxis()->axisRect()->rect();
  const double ratio = painter->device()->devicePixelRatioF();
  const QSize size = (QSizeF(area.size()) * ratio).toSize();
  if (size.isEmpty()) return;
  if (picture_.size() != size) picture_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
  picture_.setDevicePixelRatio(ratio);
  picture_.fill(Qt::transparent);
  const Scale x(keyAxis(), area.left(), ratio), y(valueAxis(), area.top(), ratio);
  for (const Trace& trace : traces_) {
    if (trace.curve.x.isEmpty()) continue;
    TraceColumns columns(size.width());
    addCurve(columns, trace.curve, x, y);
    if (trace.dashed) columns.dash(kDash * ratio, kGap * ratio);
    columns.paint(picture_, trace.colour, trace.thickness * ratio);
  }
  painter->drawImage(area.topLeft(), picture_);
  painter->setAntialiasing(true);
  painter->setPen(Qt::NoPen);
  for (const Trace& trace : traces_) {
    if (!trace.dots) continue;
    painter->setBrush(trace.colour);
    for (int i = 0; i < trace.curve.x.size(); ++i)
      if (std::isfinite(trace.curve.low[i]))
        painter->drawEllipse(
            QPointF(keyAxis()->coordToPixel(trace.curve.x[i]), valueAxis()->coordToPixel(trace.curve.low[i])), 2.4,
            2.4);
  }
}

}  // namespace heft
