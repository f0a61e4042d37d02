#include "ui/wrench_plots/trace_plottable.h"

#include <algorithm>
#include <cmath>

namespace heft {
namespace {

constexpr double kDash = 6.0, kGap = 4.5;  // [px]

/// Axis coordinates to pixels; linear, and looked up once instead of per point.
struct Scale {
  double offset, slope;
  explicit Scale(const QCPAxis* axis) {
    const QCPRange range = axis->range();
    offset = axis->coordToPixel(range.lower);
    slope = (axis->coordToPixel(range.upper) - offset) / range.size();
    offset -= slope * range.lower;
  }
  /// Far outside the lane is far enough: painting engines do not like millions of pixels.
  double operator()(double value) const { return std::clamp(offset + slope * value, -4000.0, 12000.0); }
};

}  // namespace

TracePlottable::TracePlottable(QCPAxis* keyAxis, QCPAxis* valueAxis) : QCPAbstractPlottable(keyAxis, valueAxis) {}

QCPRange TracePlottable::getKeyRange(bool& found, QCP::SignDomain) const {
  found = !curve_.x.isEmpty();
  return found ? QCPRange(curve_.x.front(), curve_.x.back()) : QCPRange();
}

QCPRange TracePlottable::getValueRange(bool& found, QCP::SignDomain, const QCPRange&) const {
  found = !curve_.x.isEmpty();
  if (!found) return {};
  return {*std::min_element(curve_.low.begin(), curve_.low.end()),
          *std::max_element(curve_.high.begin(), curve_.high.end())};
}

void TracePlottable::draw(QCPPainter* painter) {
  if (curve_.x.isEmpty()) return;
  applyDefaultAntialiasingHint(painter);
  if (curve_.crowded && !dashed_) return drawEnvelope(painter);
  const Scale x(keyAxis()), y(valueAxis());
  QVector<QPointF> points;
  points.reserve(curve_.x.size());
  const auto flush = [&] {
    if (points.isEmpty()) return;
    if (dashed_) {
      drawDashes(painter, points);
    } else {
      drawLine(painter, points);
    }
    if (dots_) {
      painter->setPen(Qt::NoPen);
      painter->setBrush(mPen.color());
      for (const QPointF& p : points) painter->drawEllipse(p, 2.4, 2.4);
    }
    points.clear();
  };
  for (int i = 0; i < curve_.x.size(); ++i) {
    const double middle = 0.5 * (curve_.low[i] + curve_.high[i]);
    // A gap in the numbers is a gap in the line.
    if (std::isfinite(middle)) {
      points.push_back({x(curve_.x[i]), y(middle)});
    } else {
      flush();
    }
  }
  flush();
}

void TracePlottable::drawEnvelope(QCPPainter* painter) const {
  const Scale x(keyAxis()), y(valueAxis());
  const double half = 0.5 * mPen.widthF();
  // In pieces: the cost of filling a jagged polygon grows faster than its length.
  constexpr int kPiece = 24;
  constexpr double kTall = 3.0;  // [px]
  const bool smooth = painter->antialiasing();
  painter->setPen(Qt::NoPen);
  painter->setBrush(mPen.color());
  QVector<QRectF> bars;
  QVector<QPointF> outline;
  for (int from = 0; from + 1 < curve_.x.size(); from += kPiece - 1) {
    const int to = std::min(from + kPiece, static_cast<int>(curve_.x.size()));
    double height = 0.0;
    for (int i = from; i < to; ++i) height += std::abs(y(curve_.low[i]) - y(curve_.high[i])) / (to - from);
    if (smooth && height < kTall) {
      outline.clear();
      for (int i = from; i < to; ++i) outline.push_back({x(curve_.x[i]), y(curve_.high[i]) - half});
      for (int i = to - 1; i >= from; --i) outline.push_back({x(curve_.x[i]), y(curve_.low[i]) + half});
      painter->drawPolygon(outline.constData(), outline.size(), Qt::WindingFill);
    } else {
      for (int i = from; i + 1 < to; ++i) {
        const double top = y(curve_.high[i]) - half, left = std::floor(x(curve_.x[i]));
        bars.push_back(QRectF(left, top, std::floor(x(curve_.x[i + 1])) - left, y(curve_.low[i]) + half - top));
      }
    }
  }
  if (bars.isEmpty()) return;
  painter->setAntialiasing(false);
  painter->drawRects(bars);
  painter->setAntialiasing(smooth);
}

void TracePlottable::drawLine(QCPPainter* painter, const QVector<QPointF>& points) const {
  painter->setPen(mPen);
  painter->setBrush(Qt::NoBrush);
  // In pieces: the cost of stroking a path grows faster than its length.
  constexpr int kPiece = 24;
  for (int from = 0; from + 1 < points.size(); from += kPiece - 1) {
    painter->drawPolyline(points.constData() + from, std::min<int>(kPiece, points.size() - from));
  }
}

void TracePlottable::drawDashes(QCPPainter* painter, const QVector<QPointF>& points) const {
  painter->setPen(mPen);
  painter->setBrush(Qt::NoBrush);
  // Dashes follow the length along the curve, anchored to its first point.
  QVector<QPointF> dash{points.front()};
  bool on = true;
  double left = kDash;
  for (int i = 1; i < points.size(); ++i) {
    QPointF from = points[i - 1];
    const QPointF to = points[i];
    double length = std::hypot(to.x() - from.x(), to.y() - from.y());
    if (length > 2000) {
      // Out of the lane and back: nobody sees these dashes.
      if (on && dash.size() > 1) painter->drawPolyline(dash.constData(), dash.size());
      dash = {to};
      continue;
    }
    while (length >= left && left > 0) {
      const double share = left / length;
      from += share * (to - from);
      length -= left;
      if (on) {
        dash.push_back(from);
        painter->drawPolyline(dash.constData(), dash.size());
      }
      on = !on;
      left = on ? kDash : kGap;
      dash = {from};
    }
    left -= length;
    if (on) dash.push_back(to);
  }
  if (on && dash.size() > 1) painter->drawPolyline(dash.constData(), dash.size());
}

}  // namespace heft
