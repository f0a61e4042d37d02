#include "ui/charts/chart.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/models/numbers.h"

namespace heft {
namespace {

QColor colourOf(ChartCurve::Colour colour, const Theme& t) {
  using C = ChartCurve::Colour;
  switch (colour) {
    case C::before:
      return t.text2;
    case C::after:
      return t.accent;
    case C::x:
      return t.axis[0];
    case C::y:
      return t.axis[1];
    case C::z:
      return t.axis[2];
    case C::dots:
    case C::text:
      break;
  }
  return t.text;
}

constexpr int kPiece = 24;  // Points of a curve that are drawn at once

struct Span {
  double low = 0.0, high = 1.0;
  bool log = false;

  double value(double v) const { return log ? std::log10(std::max(v, 1e-12)) : v; }
  double share(double v) const { return (value(v) - low) / (high - low); }
};

/// Round places for ticks, as shown values.
std::vector<double> ticksOf(const Span& span, int about) {
  if (span.log) {
    std::vector<double> out;
    for (int e = static_cast<int>(std::floor(span.low)); e <= std::ceil(span.high); ++e)
      for (const double f : {1.0, 2.0, 5.0}) {
        const double at = std::log10(f) + e;
        if (at < span.low || at > span.high || (f > 1.0 && span.high - span.low > 2.2)) continue;
        out.push_back(f * std::pow(10.0, e));
      }
    return out;
  }
  return ticksBetween(span.low, span.high, about);
}

QString tickText(double value, const std::vector<double>& ticks, bool log) {
  double least = std::abs(value);
  if (!log && ticks.size() > 1) least = ticks[1] - ticks[0];
  const int decimals = least > 0.0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(least) - 1e-9)), 0, 6) : 0;
  return numberText(value, decimals);
}

/// One chart, part by part.
struct ChartPainter {
  ChartPainter(QPainter& painter, const QRectF& whole, const Chart& what, const Theme& theme)
      : p(painter), area(whole), chart(what), t(theme), small(uiFont(type::kTick)), metrics(small) {
    p.setRenderHint(QPainter::Antialiasing);
    p.setFont(small);
    x.log = chart.logX;
    y.log = chart.logY;
  }

  ChartPlace draw(bool legend) {
    if (!spanCurves()) {
      p.setPen(t.text2);
      p.drawText(area, Qt::AlignCenter | Qt::TextWordWrap, chart.nothing);
      return {};
    }
    widenSpans();
    yTicks = ticksOf(y, area.height() > 180 ? 6 : 4);
    for (const double tick : yTicks)
      widest = std::max(widest, metrics.horizontalAdvance(tickText(tick, yTicks, y.log)));
    const double top = chart.yTitle.isEmpty() && !legend ? 4 : line + 8;
    plot = area.adjusted(widest + 8, top, -8, -(line + 6) - (chart.xTitle.isEmpty() ? 0 : line));
    drawGround();
    drawScales();
    p.save();
    p.setClipRect(plot);
    for (const auto& curve : chart.curves) curve.colour == ChartCurve::Colour::dots ? drawDots(curve) : drawLine(curve);
    drawMarker();
    p.restore();
    p.setPen(QPen(t.line, 1));
    p.drawRect(plot);
    drawHead(legend);
    return {plot, x.low, x.high, y.low, y.high};
  }

  double px(double v) const { return plot.left() + x.share(v) * plot.width(); }
  double py(double v) const { return plot.bottom() - y.share(v) * plot.height(); }

  /// False where the curves have no extent.
  bool spanCurves() {
    x.low = y.low = 1e300;
    x.high = y.high = -1e300;
    for (const auto& curve : chart.curves)
      for (const QPointF& point : curve.points) {
        if (!std::isfinite(point.x()) || !std::isfinite(point.y())) continue;
        if ((x.log && point.x() <= 0.0) || (y.log && point.y() <= 0.0)) continue;
        x.low = std::min(x.low, x.value(point.x()));
        x.high = std::max(x.high, x.value(point.x()));
        y.low = std::min(y.low, y.value(point.y()));
        y.high = std::max(y.high, y.value(point.y()));
      }
    return x.high > x.low;
  }

  /// By what else is to be seen, and some room at the edges.
  void widenSpans() {
    if (chart.band > 0.0) {
      y.low = std::min(y.low, y.log ? y.value(0.5 * chart.band) : -1.3 * chart.band);
      y.high = std::max(y.high, y.value(1.3 * chart.band));
    }
    for (const QPointF& point : chart.floor)
      if (point.y() > 0.0) {
        y.low = std::min(y.low, y.value(0.5 * point.y()));
        y.high = std::max(y.high, y.value(1.3 * point.y()));
      }
    if (chart.yHigh > chart.yLow) {
      y.low = std::min(y.low, y.value(chart.yLow));
      y.high = std::max(y.high, y.value(chart.yHigh));
    }
    if (!(y.high > y.low)) y.high = y.low + 1.0;
    const double pad = 0.06 * (y.high - y.low);
    y.low -= pad;
    y.high += pad;
    // A curve may begin at the edge; half of a dot there would be cut off.
    if (std::ranges::any_of(chart.curves, [](const auto& c) { return c.colour == ChartCurve::Colour::dots; })) {
      const double beside = 0.03 * (x.high - x.low);
      x.low -= beside;
      x.high += beside;
    }
  }

  void drawGround() {
    p.fillRect(plot, t.panel);
    p.save();
    p.setClipRect(plot);
    if (chart.band > 0.0) {
      const double bottom = y.log ? plot.bottom() : py(-chart.band);
      p.fillRect(QRectF(QPointF(plot.left(), py(chart.band)), QPointF(plot.right(), bottom)), t.noise);
    }
    if (chart.floor.size() > 1) {
      QPolygonF under;
      for (const QPointF& point : chart.floor) under << QPointF(px(point.x()), py(point.y()));
      under << QPointF(under.back().x(), plot.bottom()) << QPointF(under.front().x(), plot.bottom());
      p.setPen(Qt::NoPen);
      p.setBrush(t.noise);
      p.drawPolygon(under);
      p.setBrush(Qt::NoBrush);
    }
    p.restore();
  }

  void drawScales() {
    p.setPen(QPen(t.plotGrid, 1));
    for (const double tick : yTicks) p.drawLine(QPointF(plot.left(), py(tick)), QPointF(plot.right(), py(tick)));
    if (!y.log && y.low < 0.0 && y.high > 0.0) {
      p.setPen(QPen(t.plotZero, 1));
      p.drawLine(QPointF(plot.left(), py(0.0)), QPointF(plot.right(), py(0.0)));
    }
    p.setPen(t.text2);
    for (const double tick : yTicks)
      p.drawText(QRectF(area.left(), py(tick) - line / 2, widest + 2, line), Qt::AlignRight | Qt::AlignVCenter,
                 tickText(tick, yTicks, y.log));
    const std::vector<double> xTicks = ticksOf(x, std::max(2, static_cast<int>(plot.width() / 90)));
    for (const double tick : xTicks) {
      QString text = tickText(tick, xTicks, x.log);
      if (tick == xTicks.back() && !chart.xUnit.isEmpty()) text += QStringLiteral(" ") + chart.xUnit;
      const double half = 0.5 * metrics.horizontalAdvance(text) + 2;
      const double at = std::clamp(px(tick), area.left() + half, area.right() - half);
      p.drawText(QRectF(at - half, plot.bottom() + 3, 2 * half, line), Qt::AlignCenter, text);
    }
    if (!chart.xTitle.isEmpty())
      p.drawText(QRectF(plot.left(), area.bottom() - line, plot.width(), line), Qt::AlignRight, chart.xTitle);
  }

  void drawDots(const ChartCurve& curve) {
    QColor pale = colourOf(curve.colour, t);
    pale.setAlpha(110);
    p.setPen(Qt::NoPen);
    p.setBrush(pale);
    for (const QPointF& point : curve.points)
      if (std::isfinite(point.x()) && std::isfinite(point.y()))
        p.drawEllipse(QPointF(px(point.x()), py(point.y())), 1.6, 1.6);
    p.setBrush(Qt::NoBrush);
  }

  void drawLine(const ChartCurve& curve) {
    QPen pen(colourOf(curve.colour, t), 1.5);
    if (curve.dashed) pen.setDashPattern({3.0, 2.0});
    p.setPen(pen);
    QPainterPath path;
    bool open = false;
    for (const QPointF& point : curve.points) {
      if (!std::isfinite(point.x()) || !std::isfinite(point.y()) || (y.log && point.y() <= 0.0) ||
          (x.log && point.x() <= 0.0)) {
        open = false;
        continue;
      }
      const QPointF at(px(point.x()), py(point.y()));
      open ? path.lineTo(at) : path.moveTo(at);
      open = true;
      // A stroke that crosses itself is slow to fill: piece by piece is far quicker. Dashes need the whole path.
      if (curve.dashed || path.elementCount() < kPiece) continue;
      p.drawPath(path);
      path = QPainterPath(at);
    }
    p.drawPath(path);
  }

  void drawMarker() {
    if (chart.marker && std::isfinite(chart.marker->x()) && std::isfinite(chart.marker->y())) {
      p.setPen(QPen(t.accent, 2));
      p.setBrush(Qt::NoBrush);
      p.drawEllipse(QPointF(px(chart.marker->x()), py(chart.marker->y())), 6, 6);
    }
  }

  /// Legend from the right, title in the room that it leaves.
  void drawHead(bool legend) {
    double right = plot.right();
    if (legend) {
      for (auto curve = chart.curves.rbegin(); curve != chart.curves.rend(); ++curve) {
        if (curve->name.isEmpty()) continue;
        const double width = metrics.horizontalAdvance(curve->name);
        p.setPen(t.text2);
        p.drawText(QRectF(right - width, area.top(), width + 2, line), Qt::AlignLeft, curve->name);
        QPen pen(colourOf(curve->colour, t), 1.8);
        if (curve->dashed) pen.setDashPattern({3.0, 2.0});
        p.setPen(pen);
        p.drawLine(QPointF(right - width - 24, area.top() + line / 2),
                   QPointF(right - width - 6, area.top() + line / 2));
        right -= width + 38;
      }
    }
    QFont bold = small;
    bold.setWeight(QFont::DemiBold);
    p.setFont(bold);
    p.setPen(t.text);
    const QRectF head(area.left(), area.top(), std::max(20.0, right - area.left()), line);
    p.drawText(head, Qt::AlignLeft, QFontMetricsF(bold).elidedText(chart.yTitle, Qt::ElideRight, head.width()));
  }

  QPainter& p;
  const QRectF area;
  const Chart& chart;
  const Theme& t;
  const QFont small;
  const QFontMetricsF metrics;
  const double line = metrics.height();
  Span x, y;
  std::vector<double> yTicks;
  double widest = 0.0;  ///< Of their numbers
  QRectF plot;
};

}  // namespace

std::vector<double> ticksBetween(double low, double high, int about) {
  const auto every = [&](double step) {
    std::vector<double> at;
    for (double place = std::ceil(low / step) * step; place <= high + 1e-9 * step; place += step)
      at.push_back(std::abs(place) < 1e-9 * step ? 0.0 : place);
    return at;
  };
  constexpr std::array kRound{10.0, 5.0, 2.0, 1.0, 0.5};
  const double raw = (high - low) / about, power = std::pow(10.0, std::floor(std::log10(raw)));
  std::size_t i = 0;
  while (i + 2 < kRound.size() && kRound[i + 1] * power >= raw) ++i;
  auto out = every(kRound[i] * power);
  if (out.size() < 3)
    if (auto finer = every(kRound[i + 1] * power); std::ssize(finer) <= 2 * about + 1) out = std::move(finer);
  return out;
}

ChartPlace drawChart(QPainter& painter, const QRectF& area, const Chart& chart, const Theme& theme, bool legend) {
  return ChartPainter(painter, area, chart, theme).draw(legend);
}

QImage chartImage(const Chart& chart, QSize size, const Theme& t) {
  QImage image(2 * size, QImage::Format_RGB32);
  image.fill(t.panel);
  QPainter painter(&image);
  painter.scale(2.0, 2.0);
  drawChart(painter, QRectF(QPointF(4, 4), QSizeF(size.width() - 8, size.height() - 8)), chart, t, true);
  return image;
}

ChartWidget::ChartWidget(QWidget* parent) : QWidget(parent) { setMinimumHeight(90); }

void ChartWidget::setChart(Chart chart, bool legend) {
  chart_ = std::move(chart);
  legend_ = legend;
  update();
}

void ChartWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  place_ = drawChart(painter, QRectF(rect()), chart_, theme(), legend_);
}

void ChartWidget::mouseReleaseEvent(QMouseEvent* event) {
  QWidget::mouseReleaseEvent(event);
  if (place_.plot.isEmpty() || chart_.logX || chart_.logY) return;
  constexpr double kNear = 12.0;  // [px]
  double least = kNear * kNear;
  int best = -1;
  for (const auto& curve : chart_.curves) {
    if (curve.colour != ChartCurve::Colour::dots) continue;
    for (int i = 0; i < curve.points.size(); ++i) {
      const QPointF& point = curve.points[i];
      if (!std::isfinite(point.x()) || !std::isfinite(point.y())) continue;
      const QRectF& plot = place_.plot;
      const double x = plot.left() + (point.x() - place_.xLow) / (place_.xHigh - place_.xLow) * plot.width();
      const double y = plot.bottom() - (point.y() - place_.yLow) / (place_.yHigh - place_.yLow) * plot.height();
      const double away = std::pow(x - event->pos().x(), 2) + std::pow(y - event->pos().y(), 2);
      if (away >= least) continue;
      least = away;
      best = i;
    }
  }
  if (best >= 0) emit dotPicked(best);
}

void ChartWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace heft
