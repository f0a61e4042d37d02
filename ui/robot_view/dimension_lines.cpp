#include "ui/robot_view/dimension_lines.h"

#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft {
namespace {

constexpr double kAway = 36, kBeyond = 8, kShortest = 18, kTick = 4;  // [px]

struct Placed {
  QPointF from, to;      ///< The edge.
  QPointF away;          ///< Unit vector from the body.
  QRectF label;
};

}  // namespace

void paintDimensions(QPainter& painter, const std::vector<DimensionLine>& lines, const Isometry3d& X_BS,
                     const Vector3d& centre, const HandleSet::View& view) {
  const Theme& t = theme();
  const QFont font = uiFont(type::kCaption, QFont::DemiBold);
  const QFontMetricsF metrics(font);
  const QPointF middle = view.pixelOf(X_BS * centre);
  const QRectF picture(QPointF(8, 8), view.size - QSizeF(16, 16));
  std::vector<std::pair<const DimensionLine*, Placed>> placed;
  for (const DimensionLine& line : lines) {
    Placed best;
    double most = -1e9;
    for (const auto& [a, b] : line.edges) {
      Placed here{view.pixelOf(X_BS * a), view.pixelOf(X_BS * b), {}, {}};
      const QLineF edge(here.from, here.to);
      if (edge.length() < kShortest) continue;
      const QPointF along = (here.to - here.from) / edge.length();
      here.away = QPointF(-along.y(), along.x());
      const double side = QPointF::dotProduct(edge.center() - middle, here.away);
      if (side < 0) here.away = -here.away;
      const QSizeF size(metrics.horizontalAdvance(line.text) + 14, metrics.height() + 7);
      here.label = QRectF(edge.center() + kAway * here.away - QPointF(size.width() / 2, size.height() / 2), size);
      double score = std::abs(side);
      for (const auto& [other, taken] : placed) {
        Q_UNUSED(other);
        if (taken.label.adjusted(-4, -4, 4, 4).intersects(here.label)) score -= 400;
      }
      if (!picture.contains(here.label)) score -= 800;
      if (score <= most) continue;
      most = score;
      best = here;
    }
    if (most > -1e9) placed.emplace_back(&line, best);
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [line, at] : placed) {
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
  painter.setFont(font);
  for (const auto& [line, at] : placed) {
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
