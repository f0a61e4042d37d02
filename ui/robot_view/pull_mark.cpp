#include "ui/robot_view/pull_mark.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft {

void paintPull(QPainter& painter, const PullMark& mark, const Vector3d& tool, const HandleSet::View& view) {
  const Theme& t = theme();
  QPointF from = view.pixelOf(tool), to = view.pixelOf(mark.anchor);
  const QRectF picture(QPointF(24, 24), view.size - QSizeF(80, 48));
  // An anchor outside the picture: the spring leaves towards it and the mark stands at the edge.
  for (int i = 0; i < 40 && !picture.contains(to); ++i) to = from + 0.9 * (to - from);
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
    spring.lineTo(from + (lead + coil * u) * along + 6.0 * std::sin(phase) * across + 3.0 * (1.0 - std::cos(phase)) * along);
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

  const QFont bold = uiFont(type::kCaption, QFont::DemiBold), plain = uiFont(type::kCaption);
  const QFontMetricsF metrics(bold);
  const double width = std::max(metrics.horizontalAdvance(mark.title), QFontMetricsF(plain).horizontalAdvance(mark.note)) + 16;
  const double height = (mark.note.isEmpty() ? 1 : 2) * metrics.height() + 8;
  QRectF label(to + QPointF(26, -0.5 * height), QSizeF(width, height));
  if (label.right() > view.size.width() - 8) label.moveRight(to.x() - 26);
  label.moveTop(std::clamp(label.top(), 8.0, std::max(8.0, view.size.height() - height - 8)));
  painter.setPen(QPen(t.line, 1));
  painter.setBrush(t.panel);
  painter.drawRoundedRect(label, 4, 4);
  painter.setPen(t.text);
  painter.setFont(bold);
  painter.drawText(label.adjusted(8, 4, -8, 0), Qt::AlignLeft | Qt::AlignTop, mark.title);
  if (!mark.note.isEmpty()) {
    painter.setFont(plain);
    painter.setPen(t.text2);
    painter.drawText(label.adjusted(8, 4, -8, -4), Qt::AlignLeft | Qt::AlignBottom, mark.note);
  }
  painter.restore();
}

}  // namespace heft
