#include "ui/robot_view/pull_mark.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft {

QPointF pullPixel(const PullMark& mark, const Vector3d& tool, const HandleSet::View& view) {
  const QPointF from = view.pixelOf(tool);
  QPointF to = view.pixelOf(mark.anchor);
  const QRectF picture(QPointF(24, 24), view.size - QSizeF(80, 48));
  // An anchor outside the picture: the spring leaves towards it and the mark stands at the edge.
  for (int i = 0; i < 40 && !picture.contains(to); ++i) to = from + 0.9 * (to - from);
  return to;
}

void paintPull(QPainter& painter, const PullMark& mark, const Vector3d& tool, const HandleSet::View& view) {
  const Theme& t = theme();
  const QPointF from = view.pixelOf(tool), to = pullPixel(mark, tool, view);
  const QLineF line(from, to);
  if (line.length() < 12) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF along = (to - from) / line.length(), across(-along.y(), along.x());
  const int turns = std::clamp(static_cast<int>(line.length() / 9), 4, 24);
  QPainterPath spring(from);
  const double lead = std::min(14.0, 0.15 * line.length()), coil = line.length() - 2 * lead;
  spring.lineTo(from + lead * along);
  for (int i = 0; i < 16 * turns; ++i) {
    const double u = (i + 1.0) / (16.0 * turns), phase = 2.0 * M_PI * turns * u;
    spring.lineTo(from + (lead + coil * u) * along + 6.0 * std::sin(phase) * across +
                  3.0 * (1.0 - std::cos(phase)) * along);
  }
  spring.lineTo(to);
  painter.setPen(QPen(t.accent, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(spring);
  QColor halo = t.accent;
  halo.setAlpha(70);
  painter.setPen(Qt::NoPen);
  painter.setBrush(halo);
  painter.drawEllipse(to, 15, 15);
  painter.setBrush(t.accentFill);
  painter.drawEllipse(to, 5, 5);
  painter.restore();
}

}  // namespace heft
