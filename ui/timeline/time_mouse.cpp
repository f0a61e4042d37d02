#include "ui/timeline/time_mouse.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "ui/timeline/time_axis.h"

namespace heft {
namespace {

constexpr int kClickReach = 4;  ///< [px] Less is a click.

}  // namespace

TimeMouse::TimeMouse(TimeAxis* axis, QWidget* widget) : QObject(widget), axis_(axis), widget_(widget) {
  widget->setMouseTracking(true);
  widget->installEventFilter(this);
}

void TimeMouse::wheel(TimeAxis* axis, QWheelEvent* event, int width) {
  const QPoint delta = event->angleDelta();
  if (std::abs(delta.x()) > std::abs(delta.y()) || (event->modifiers() & Qt::ShiftModifier)) {
    axis->pan(-axis->span() * (delta.x() != 0 ? delta.x() : delta.y()) / 1200.0);
  } else {
    axis->zoom(std::pow(0.8, delta.y() / 120.0), axis->toTime(event->position().x(), width));
  }
  event->accept();
}

std::optional<std::pair<int, int>> TimeMouse::band() const {
  if (!pressed_ || !moved_ || pans_) return std::nullopt;
  return std::minmax(*pressed_, now_);
}

void TimeMouse::press(const QMouseEvent* event) {
  pans_ = event->button() == Qt::MiddleButton ||
          (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ShiftModifier));
  pressed_.reset();
  if (pans_ || event->button() == Qt::LeftButton) pressed_ = now_ = event->pos().x();
  moved_ = false;
  pressedLower_ = axis_->lower();
}

void TimeMouse::move(const QMouseEvent* event) {
  pointer_ = event->buttons() == Qt::NoButton ? std::optional(event->pos()) : std::nullopt;
  if (pressed_ && event->buttons() != Qt::NoButton) {
    now_ = event->pos().x();
    moved_ = moved_ || std::abs(now_ - *pressed_) > kClickReach;
    if (moved_ && pans_) {
      const double seconds = axis_->toTime(*pressed_, widget_->width()) - axis_->toTime(now_, widget_->width());
      axis_->show(pressedLower_ + seconds, pressedLower_ + seconds + axis_->span());
    }
  }
  widget_->update();
}

void TimeMouse::release(const QMouseEvent* event) {
  if (!pressed_) return;
  const double from = axis_->toTime(*pressed_, widget_->width()),
               to = axis_->toTime(event->pos().x(), widget_->width());
  const bool moved = moved_;
  pressed_.reset();
  if (!moved) {
    emit timePicked(to);
  } else if (!pans_) {
    axis_->show(std::min(from, to), std::max(from, to));
  }
  widget_->update();
}

bool TimeMouse::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::Wheel:
      wheel(axis_, static_cast<QWheelEvent*>(event), widget_->width());
      return true;
    case QEvent::MouseButtonPress:
      press(static_cast<QMouseEvent*>(event));
      return false;
    case QEvent::MouseMove:
      move(static_cast<QMouseEvent*>(event));
      return false;
    case QEvent::MouseButtonRelease:
      release(static_cast<QMouseEvent*>(event));
      return false;
    case QEvent::MouseButtonDblClick:
      pressed_.reset();
      axis_->showAll();
      return false;
    case QEvent::Leave:
      pointer_.reset();
      widget_->update();
      return false;
    default:
      return false;
  }
}

}  // namespace heft
