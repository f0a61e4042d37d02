#include "ui/robot_view/gap_mark.h"

#include <QCoreApplication>
#include <QPainter>

#include "ui/models/numbers.h"
#include "ui/theme/theme.h"

namespace heft {

namespace {

class GapMark {
  Q_DECLARE_TR_FUNCTIONS(GapMark)
};

}  // namespace

void paintGap(QPainter& painter, const Nearest& gap, const HandleSet::View& view) {
  const Theme& t = theme();
  const QPointF from = view.pixelOf(gap.onFirst), to = view.pixelOf(gap.onSecond);
  const QColor colour = gap.tooNear() ? t.bad : t.text;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  // On arm and floor alike.
  painter.setPen(QPen(t.panel, 5.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
  painter.setPen(QPen(colour, gap.tooNear() ? 3.0 : 2.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
  painter.setBrush(colour);
  painter.setPen(QPen(t.panel, 1.5));
  for (const QPointF& end : {from, to}) painter.drawEllipse(end, 4.5, 4.5);
  painter.restore();
}

QString gapTitle(const Nearest& gap) {
  const QString distance = GapMark::tr("%1 mm").arg(numberText(1e3 * gap.distance, 0));
  return gap.tooNear() ? GapMark::tr("Too near: %1").arg(distance) : distance;
}

QString gapNote(const Nearest& gap) {
  return GapMark::tr("%1 and %2").arg(QString::fromStdString(gap.first), QString::fromStdString(gap.second));
}

}  // namespace heft
