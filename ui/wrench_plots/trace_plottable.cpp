#include "ui/wrench_plots/trace_plottable.h"

#include <algorithm>
#include <cmath>

#include "ui/wrench_plots/trace_raster.h"

namespace heft {
namespace {

constexpr double kDash = 6.0, kGap = 4.5;  // [px]

/// Axis coordinates to pixels of a picture; linear, and looked up once instead of per point.
TraceScale scaleOf(const QCPAxis* axis, double corner, double ratio) {
  const QCPRange range = axis->range();
  const double first = axis->coordToPixel(range.lower), last = axis->coordToPixel(range.upper);
  const double slope = ratio * (last - first) / range.size();
  return {ratio * (first - corner) - slope * range.lower, slope};
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
  const TraceScale x = scaleOf(keyAxis(), area.left(), ratio), y = scaleOf(valueAxis(), area.top(), ratio);
  for (const Trace& trace : traces_) {
    if (trace.curve.x.isEmpty()) continue;
    TraceColumns columns(size.width());
    addThinned(columns, trace.curve, x, y);
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
