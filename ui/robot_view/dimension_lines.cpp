#include "ui/robot_view/dimension_lines.h"

#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft {
namespace {

constexpr double kAway = 36, kBeyond = 8, kShortest = 18, kTick = 4;  // [px]

QFont labelFont() { return uiFont(type::kCaption, QFont::DemiBold); }

}  // namespace

std::vector<PlacedDimension> placeDimensions(const std::vector<DimensionLine>& lines, const Isometry3d& X_BS,
                                             const HandleSet::View& view) {
  const QFontMetricsF metrics(labelFont());
  Vector3d centre = Vector3d::Zero();
  int ends = 0;
  for (const DimensionLine& line : lines)
    for (const auto& [a, b] : line.edges) centre += a + b, ends += 2;
  const QPointF middle = view.pixelOf(X_BS * Vector3d(centre / std::max(1, ends)));
  const QRectF picture(QPointF(8, 8), view.size - QSizeF(16, 16));
  std::vector<PlacedDimension> placed;
  for (const DimensionLine& line : lines) {
    PlacedDimension best;
    double most = -1e9;
    for (const auto& [a, b] : line.edges) {
      PlacedDimension here{&line, view.pixelOf(X_BS * a), view.pixelOf(X_BS * b), {}, {}};
      const QLineF edge(here.from, here.to);
      if (edge.length() < kShortest) continue;
      const QPointF along = (here.to - here.from) / edge.length();
      here.away = QPointF(-along.y(), along.x());
      const double side = QPointF::dotProduct(edge.center() - middle, here.away);
      if (side < 0) here.away = -here.away;
      const QSizeF size(metrics.horizontalAdvance(line.text) + 14, metrics.height() + 7);
      here.label = QRectF(edge.center() + kAway * here.away - QPointF(size.width() / 2, size.height() / 2), size);
      double score = std::abs(side);
      for (const auto& taken : placed)
        if (taken.label.adjusted(-4, -4, 4, 4).intersects(here.label)) score -= 400;
      if (!picture.contains(here.label)) score -= 800;
      if (score <= most) continue;
      most = score;
      best = here;
    }
    if (most > -1e9) placed.push_back(best);
  }
  return placed;
}

void paintDimensions(QPainter& painter, const std::vector<PlacedDimension>& placed) {
  const Theme& t = theme();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const PlacedDimension& at : placed) {
    const DimensionLine* line = at.line;
    const QColor colour = line->tone >= 0 && line->tone < 3 ? t.axis[static_cast<std::size_t>(line->tone)] : t.text2;
    const QPointF from = at.from + kAway * at.away, to = at.to + kAway * at.away;
    painter.setPen(QPen(t.text2, 1));
    painter.drawLine(at.from, from + kBeyond * at.away);
    painter.drawLine(at.to, to + kBeyond * at.away);
    painter.setPen(QPen(colour, line->strong ? 2.6 : 1.6));
    painter.drawLine(from, to);
    const QPointF along = (to - from) / std::max(1.0, QLineF(from, to).length());
    for (const QPointF& end : {from, to})
      painter.drawLine(end - kTick * (at.away + along), end + kTick * (at.away + along));
  }
  painter.setFont(labelFont());
  for (const PlacedDimension& at : placed) {
    const DimensionLine* line = at.line;
    const QColor colour = line->tone >= 0 && line->tone < 3 ? t.axis[static_cast<std::size_t>(line->tone)] : t.text2;
    painter.setPen(QPen(colour, line->strong ? 2.2 : 1.2));
    painter.setBrush(t.panel);
    painter.drawRoundedRect(at.label, 4, 4);
    painter.setPen(t.text);
    painter.drawText(at.label, Qt::AlignCenter, line->text);
  }
  painter.restore();
}

}  // namespace heft
