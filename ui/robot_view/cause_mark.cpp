#include "ui/robot_view/cause_mark.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft {
namespace {

using Kind = CauseMark::Kind;

constexpr double kLength = 0.17;  ///< [m] Of axes and arrows

Matrix3d turned(const Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix() : Matrix3d::Identity();
}

/// Of the stated gravity turned towards the true one, further than it is.
Vector3d tilted(const CauseMark& mark, const Vector3d& down) {
  const Vector3d to = mark.vector.normalized(), axis = down.cross(to);
  const double sine = axis.norm();
  if (sine < 1e-9) return down;
  const double angle = std::min(1.2, mark.enlarged * std::atan2(sine, down.dot(to)));
  return turned(axis / sine * angle) * down;
}

struct Ends {
  Vector3d from, to;  ///< B axes
};

Ends endsOf(const CauseMark& mark, const Isometry3d& X_BS, const Vector3d& down) {
  const Vector3d at = X_BS * mark.at;
  switch (mark.kind) {
    case Kind::gravity:
      return {X_BS.translation(), X_BS.translation() + 1.25 * kLength * tilted(mark, down)};
    case Kind::push: {
      const Vector3d along = (mark.inBase ? mark.vector : X_BS.linear() * mark.vector).normalized();
      return {at - kLength * along, at};
    }
    case Kind::load:
      return {at, at + 0.8 * kLength * mark.vector.normalized()};
    case Kind::misplaced:
      return {X_BS.translation(), X_BS * (mark.enlarged * mark.vector)};
    case Kind::turnedFrame:
      return {X_BS.translation(), X_BS * (turned(mark.enlarged * mark.vector) * Vector3d(0.0, 0.0, kLength))};
    case Kind::swing:
      break;
  }
  return {at, at};
}

void arrow(QPainter& p, const QPointF& from, const QPointF& to, const QPen& pen) {
  const QLineF line(from, to);
  if (line.length() < 2.0) return;
  const QPointF along = (to - from) / line.length(), across(-along.y(), along.x());
  p.setPen(pen);
  p.drawLine(from, to - 8.0 * along);
  QPainterPath head(to);
  head.lineTo(to - 12.0 * along + 5.5 * across);
  head.lineTo(to - 12.0 * along - 5.5 * across);
  head.closeSubpath();
  p.fillPath(head, pen.color());
}

void turnedFrame(QPainter& p, const CauseMark& mark, const Isometry3d& X_BS, const HandleSet::View& view) {
  const Matrix3d R = turned(mark.enlarged * mark.vector);
  const QPointF origin = view.pixelOf(X_BS.translation());
  for (int axis = 0; axis < 3; ++axis) {
    const QPointF stated = view.pixelOf(X_BS * (kLength * Vector3d::Unit(axis))),
                  true_ = view.pixelOf(X_BS * (kLength * R.col(axis)));
    QColor wedge = theme().accent;
    wedge.setAlpha(60);
    QPainterPath between(origin);
    between.lineTo(stated);
    between.lineTo(true_);
    between.closeSubpath();
    p.fillPath(between, wedge);
    p.setPen(QPen(theme().axis[static_cast<std::size_t>(axis)], 1.5, Qt::DashLine));
    p.drawLine(origin, stated);
    arrow(p, origin, true_, QPen(theme().axis[static_cast<std::size_t>(axis)], 3.0, Qt::SolidLine, Qt::RoundCap));
  }
}

void swing(QPainter& p, const QPointF& at) {
  QPen pen(theme().accent, 2.2, Qt::SolidLine, Qt::RoundCap);
  const QRectF arc(at - QPointF(30, 34), QSizeF(60, 60));
  p.setPen(pen);
  p.setBrush(Qt::NoBrush);
  p.drawArc(arc, 225 * 16, 90 * 16);
  for (const double side : {-1.0, 1.0}) {
    const double angle = (90.0 + 45.0 * side) * M_PI / 180.0;
    const QPointF end = arc.center() + QPointF(30 * std::cos(angle), 30 * std::sin(angle));
    p.drawLine(end, end + QPointF(2 * -side, -9));
    p.drawLine(end, end + QPointF(8 * side, 1));
  }
  p.setBrush(theme().accentFill);
  p.setPen(Qt::NoPen);
  p.drawEllipse(arc.center() + QPointF(0, 30), 6, 6);
  p.setBrush(Qt::NoBrush);
}

}  // namespace

QPointF causePixel(const CauseMark& mark, const Isometry3d& X_BS, const Vector3d& down, const HandleSet::View& view) {
  const Ends ends = endsOf(mark, X_BS, down);
  return view.pixelOf(mark.kind == Kind::push ? ends.from : ends.to);
}

void paintCause(QPainter& painter, const CauseMark& mark, const Isometry3d& X_BS, const Vector3d& down,
                const HandleSet::View& view) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const Ends ends = endsOf(mark, X_BS, down);
  const QPointF from = view.pixelOf(ends.from), to = view.pixelOf(ends.to);
  const QPen pen(theme().accent, 3.5, Qt::SolidLine, Qt::RoundCap);
  switch (mark.kind) {
    case Kind::turnedFrame:
      turnedFrame(painter, mark, X_BS, view);
      break;
    case Kind::swing:
      swing(painter, to);
      break;
    case Kind::gravity: {
      painter.setPen(QPen(theme().gravity, 1.5, Qt::DashLine));
      painter.drawLine(from, view.pixelOf(X_BS.translation() + 1.25 * kLength * down));
      arrow(painter, from, to, pen);
      break;
    }
    case Kind::misplaced: {
      QColor halo = theme().accent;
      halo.setAlpha(70);
      painter.setPen(Qt::NoPen);
      painter.setBrush(halo);
      painter.drawEllipse(to, 12, 12);
      painter.setBrush(Qt::NoBrush);
      arrow(painter, from, to, pen);
      break;
    }
    case Kind::push:
    case Kind::load:
      arrow(painter, from, to, pen);
      break;
  }
  painter.restore();
}

}  // namespace heft
