#include "ui/robot_view/handles.h"

#include <QPainter>
#include <QPainterPath>
#include <QRadialGradient>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft {
namespace {

constexpr double kReach = 14;        ///< [px] about a knob
constexpr double kKnob = 6.5;        ///< [px]
constexpr double kArrow = 40;        ///< [px] seen from the side
constexpr double kLeastArrow = 0.3;  ///< Seen more from its end than this share of its length it is not offered.
constexpr double kFine = 0.1;
constexpr int kCircleSteps = 72;
constexpr double kTurn = 6.283185307179586;

QColor toneColour(int tone) {
  const Theme& t = theme();
  return tone >= 0 && tone < 3 ? t.axis[static_cast<std::size_t>(tone)] : t.text2;
}

}  // namespace

QPointF HandleSet::View::pixelOf(const Vector3d& point) const {
  const Eigen::Vector2d p = camera.pixelOf(point, size.width(), size.height());
  return {p.x(), p.y()};
}

Ray HandleSet::View::rayThrough(QPointF pixel) const {
  return camera.rayThrough({pixel.x(), pixel.y()}, size.width(), size.height());
}

HandleSet::HandleSet(Frame frame, QObject* parent) : QObject(parent), frame_(frame) {}

void HandleSet::setHandles(std::vector<Handle> handles) {
  handles_ = std::move(handles);
  const auto present = [&](int id) {
    return std::any_of(handles_.begin(), handles_.end(), [&](const Handle& h) { return h.id == id; });
  };
  if (hovered_ && !present(*hovered_)) hovered_.reset();
  emit changed();
}

std::optional<int> HandleSet::current() const { return grabbed_ ? std::optional(grabbed_->handle.id) : hovered_; }

QString HandleSet::tip() const {
  const auto id = current();
  for (const Handle& handle : handles_)
    if (id && handle.id == *id) return handle.tip;
  return {};
}

void HandleSet::setPose(const Isometry3d& X_BF) { X_BF_ = frame_ == Frame::sensor ? X_BF : Isometry3d::Identity(); }

std::optional<QPointF> HandleSet::knobOf(const Handle& handle, const View& view) const {
  const Vector3d point = X_BF_ * handle.point;
  if (handle.way != Handle::Way::plane) {
    const Vector3d axis = X_BF_.linear() * handle.axis;
    const double along = std::abs((point - view.camera.position()).normalized().dot(axis));
    // A line is lost when seen from its end, a circle when seen from its edge.
    if (handle.way == Handle::Way::line ? 1 - along * along < kLeastArrow * kLeastArrow : along < 0.17)
      return std::nullopt;
  }
  return view.pixelOf(point);
}

std::optional<QPointF> HandleSet::knob(int id, const View& view) const {
  for (const Handle& handle : handles_)
    if (handle.id == id) return knobOf(handle, view);
  return std::nullopt;
}

const Handle* HandleSet::find(QPointF pixel, const View& view) const {
  const Handle* best = nullptr;
  double least = 1.0;
  for (const Handle& handle : handles_) {
    const auto knob = knobOf(handle, view);
    if (!knob) continue;
    double reach = kReach;
    QPointF near = *knob;
    if (handle.shown && handle.arrow && handle.way == Handle::Way::line) {
      // The arrow is part of the handle.
      const Vector3d point = X_BF_ * handle.point;
      const double length = kArrow * view.camera.metresPerPixel(point, view.size.height());
      const QPointF step = view.pixelOf(point + length * (X_BF_.linear() * handle.axis)) - *knob;
      const double square = QPointF::dotProduct(step, step);
      const double share = square > 0 ? QPointF::dotProduct(pixel - *knob, step) / square : 0.0;
      near = *knob + std::clamp(share, 0.0, 1.0) * step;
    }
    // A body that can be grabbed anywhere loses against a knob on it.
    double penalty = 0.0;
    const double knobDistance = std::hypot(pixel.x() - near.x(), pixel.y() - near.y()) / reach;
    double distance = knobDistance;
    if (handle.grabRadius > 0 && knobDistance >= 1) {
      reach = handle.grabRadius / view.camera.metresPerPixel(X_BF_ * handle.point, view.size.height());
      distance = std::hypot(pixel.x() - knob->x(), pixel.y() - knob->y()) / std::max(1.0, reach);
      penalty = 1.0;
    }
    if (distance >= 1) continue;
    if (!best || distance + penalty < least) {
      best = &handle;
      least = distance + penalty;
    }
  }
  return best;
}

bool HandleSet::hover(QPointF pixel, const View& view) {
  const Handle* found = find(pixel, view);
  const std::optional<int> now = found ? std::optional(found->id) : std::nullopt;
  if (now != hovered_) {
    hovered_ = now;
    emit changed();
  }
  return found != nullptr;
}

void HandleSet::leave() {
  if (!hovered_) return;
  hovered_.reset();
  emit changed();
}

bool HandleSet::press(QPointF pixel, const View& view) {
  const Handle* found = find(pixel, view);
  if (!found) return false;
  const Ray ray = view.rayThrough(pixel);
  Grab grab{*found, X_BF_, 0.0, X_BF_ * found->point, 0.0, 0.0, Vector3d::Zero()};
  const Vector3d axis = X_BF_.linear() * found->axis;
  switch (found->way) {
    case Handle::Way::line: {
      const auto along = alongLine(ray, grab.point, axis);
      if (!along) return false;
      grab.along = *along;
      break;
    }
    case Handle::Way::plane: {
      const Vector3d normal = axis.isZero() ? Vector3d(view.camera.position() - view.camera.target).normalized() : axis;
      const auto at = onPlane(ray, grab.point, normal);
      if (!at) return false;
      grab.point = *at;
      break;
    }
    case Handle::Way::circle: {
      const Vector3d centre = X_BF_ * found->centre;
      const auto at = onPlane(ray, centre, axis);
      if (!at) return false;
      grab.from = *at - centre;
      break;
    }
  }
  grabbed_ = grab;
  hovered_ = found->id;
  emit changed();
  emit grabbed(grab.handle.id);
  return true;
}

void HandleSet::move(QPointF pixel, const View& view, bool fine) {
  if (!grabbed_) return;
  Grab& grab = *grabbed_;
  const Ray ray = view.rayThrough(pixel);
  const Vector3d axis = grab.X_BF.linear() * grab.handle.axis;
  HandleDrag drag;
  drag.handle = grab.handle;
  drag.fine = fine;
  const double gear = fine ? kFine : 1.0;
  switch (grab.handle.way) {
    case Handle::Way::line: {
      const auto along = alongLine(ray, grab.X_BF * grab.handle.point, axis);
      if (!along) return;
      drag.along = gear * (*along - grab.along);
      drag.shift = drag.along * grab.handle.axis;
      break;
    }
    case Handle::Way::plane: {
      const Vector3d normal = axis.isZero() ? Vector3d(view.camera.position() - view.camera.target).normalized() : axis;
      const auto at = onPlane(ray, grab.point, normal);
      if (!at) return;
      drag.shift = gear * (grab.X_BF.linear().transpose() * (*at - grab.point));
      break;
    }
    case Handle::Way::circle: {
      const Vector3d centre = grab.X_BF * grab.handle.centre;
      const auto at = onPlane(ray, centre, axis);
      if (!at) return;
      const double now = angleAbout(axis, grab.from, *at - centre);
      grab.angle += std::remainder(now - grab.lastAngle, kTurn);
      grab.lastAngle = now;
      drag.angle = gear * grab.angle;
      break;
    }
  }
  emit dragged(drag);
}

void HandleSet::release() {
  if (!grabbed_) return;
  const int id = grabbed_->handle.id;
  grabbed_.reset();
  emit changed();
  emit released(id);
}

void HandleSet::cancel() {
  if (!grabbed_) return;
  const int id = grabbed_->handle.id;
  grabbed_.reset();
  emit changed();
  emit cancelled(id);
}

void HandleSet::paint(QPainter& painter, const View& view) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const auto now = current();
  // The one in use on top.
  for (const bool top : {false, true}) {
    for (const Handle& handle : handles_) {
      const bool isCurrent = now && *now == handle.id;
      if (!handle.shown || isCurrent != top) continue;
      if (const auto knob = knobOf(handle, view)) paintHandle(painter, view, handle, *knob, isCurrent);
    }
  }
  painter.restore();
}

void HandleSet::paintHandle(QPainter& painter, const View& view, const Handle& handle, QPointF knob,
                            bool isCurrent) const {
  const Theme& t = theme();
  const QColor colour = toneColour(handle.tone);
  const Vector3d point = X_BF_ * handle.point, axis = X_BF_.linear() * handle.axis;
  if (handle.way == Handle::Way::circle) {
    const Vector3d centre = X_BF_ * handle.centre, x = point - centre, y = axis.cross(x);
    const Vector3d toEye = (view.camera.position() - centre).normalized();
    for (int i = 0; i < kCircleSteps; ++i) {
      const double a = kTurn * i / kCircleSteps, b = kTurn * (i + 1) / kCircleSteps;
      const Vector3d from = std::cos(a) * x + std::sin(a) * y, to = std::cos(b) * x + std::sin(b) * y;
      QColor shade = colour;
      if (from.dot(toEye) < 0) shade.setAlpha(70);  // The far half.
      painter.setPen(QPen(shade, isCurrent ? 3.0 : 2.0, Qt::SolidLine, Qt::FlatCap));
      painter.drawLine(view.pixelOf(centre + from), view.pixelOf(centre + to));
    }
  }
  if (handle.way == Handle::Way::line && handle.arrow) {
    const double length = kArrow * view.camera.metresPerPixel(point, view.size.height());
    const QPointF step = view.pixelOf(point + length * axis) - knob;
    const double long_ = std::max(1.0, std::hypot(step.x(), step.y()));
    const QPointF along = step / long_, across(-along.y(), along.x());
    const QPointF tip = knob + step, neck = tip - 11 * along;
    painter.setPen(QPen(colour, isCurrent ? 6 : 4.5, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(knob, neck + along);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF({tip, neck + 6.5 * across, neck - 6.5 * across}));
    if (handle.tone >= 0 && handle.tone < 3) {
      const QPointF letter = tip + 9 * along;
      painter.setPen(QPen(colour, 1.8));
      painter.setBrush(t.panel);
      painter.drawEllipse(letter, 8.5, 8.5);
      painter.setPen(t.text);
      painter.setFont(uiFont(type::kTick, QFont::Bold));
      painter.drawText(QRectF(letter - QPointF(8, 9), QSizeF(16, 17)), Qt::AlignCenter,
                       QString(QChar("xyz"[handle.tone])));
    }
  }
  const double radius = isCurrent ? kKnob + 2 : kKnob;
  QRadialGradient ball(knob + QPointF(-radius / 3, -radius / 3), 1.7 * radius);
  ball.setColorAt(0.0, Qt::white);
  ball.setColorAt(1.0, QColor("#C9D2DA"));
  painter.setPen(QPen(isCurrent ? t.accent : QColor("#6B7884"), isCurrent ? 2.4 : 1.2));
  painter.setBrush(ball);
  painter.drawEllipse(knob, radius, radius);
}

}  // namespace heft
