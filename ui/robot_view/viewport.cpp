#include "ui/robot_view/viewport.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft {
namespace {

constexpr int kRest = 160;     ///< [ms] without a frame: what moved is at rest, and worth a smooth frame.
constexpr int kSlowest = 700;  ///< [ms] Frames further apart do not belong to one motion.

}  // namespace

Viewport::Viewport(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(false);
  frame_.setSingleShot(true);
  frame_.setInterval(0);
  connect(&frame_, &QTimer::timeout, this, [this] {
    if (isVisible()) renderer_.order(order(false));
  });
  settle_.setSingleShot(true);
  sinceFrame_.start();
  connect(&settle_, &QTimer::timeout, this, [this] { renderer_.order(order(true)); });
  connect(&renderer_, &SceneRenderer::drawn, this, [this] {
    if (auto picture = renderer_.take()) show(std::move(*picture));
  });
}

void Viewport::setHandles(HandleSet* handles) {
  if (handles_ == handles) return;
  if (handles_) {
    handles_->cancel();
    handles_->leave();
    disconnect(handles_, nullptr, this, nullptr);
  }
  handles_ = handles;
  setMouseTracking(handles_ != nullptr);
  if (handles_) connect(handles_, &HandleSet::changed, this, &Viewport::showCursor);
  showCursor();
}

void Viewport::showCursor() {
  if (handles_ && handles_->dragging()) {
    setCursor(Qt::ClosedHandCursor);
  } else if (handles_ && handles_->current()) {
    setCursor(Qt::OpenHandCursor);
  } else {
    unsetCursor();
  }
  setToolTip(handles_ && !handles_->dragging() ? handles_->tip() : QString());
}

PictureOrder Viewport::order(bool smooth) const {
  const bool byHand = QGuiApplication::mouseButtons() != Qt::NoButton;
  return {scene_, &theme(), camera_, size(), devicePixelRatioF(), smooth, !smooth && !byHand};
}

void Viewport::requestFrame() {
  if (!frame_.isActive()) frame_.start();
}

void Viewport::renderNow() {
  frame_.stop();
  show(renderer_.drawNow(order(true)));
}

void Viewport::show(ScenePicture picture) {
  if (picture.image.isNull()) return;
  picture_ = std::move(picture);
  update();
  emit rendered();
  if (picture_.smooth) {
    settle_.stop();
  } else {
    // Where frames come slowly one after another, things have not come to rest between two of them.
    const auto gap = static_cast<int>(std::min<qint64>(sinceFrame_.restart(), kSlowest));
    settle_.start(gap < kSlowest ? std::max(kRest, 3 * gap) : kRest);
  }
}

void Viewport::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!picture_.image.isNull()) {
    painter.drawImage(rect(), picture_.image);
    return;
  }
  painter.fillRect(rect(), theme().skyBottom);
  if (renderer_.works()) return;
  painter.setPen(theme().text2);
  painter.drawText(
      rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
      tr("The 3D view needs OpenGL, which this computer does not offer. Everything else works without it."));
}

void Viewport::cameraChanged() {
  emit cameraMoved();
  requestFrame();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  last_ = event->pos();
  event->accept();
  if (handles_ && event->button() == Qt::LeftButton) handles_->press(event->localPos(), handleView());
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  if (handles_ && handles_->dragging()) {
    last_ = event->pos();
    handles_->move(event->localPos(), handleView(), event->modifiers() & Qt::ShiftModifier);
    return;
  }
  if (handles_ && event->buttons() == Qt::NoButton) handles_->hover(event->localPos(), handleView());
  const QPoint step = event->pos() - last_;
  last_ = event->pos();
  const bool shift = event->modifiers() & Qt::ShiftModifier;
  if ((event->buttons() & Qt::LeftButton) && !shift) {
    camera_.orbit(step.x(), step.y());
  } else if (event->buttons() & (Qt::LeftButton | Qt::MiddleButton | Qt::RightButton)) {
    camera_.pan(step.x(), step.y(), height());
  } else {
    return;
  }
  cameraChanged();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (handles_ && event->button() == Qt::LeftButton) handles_->release();
  event->accept();
}

void Viewport::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  if (handles_ && !handles_->dragging()) handles_->leave();
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) { event->accept(); }

void Viewport::wheelEvent(QWheelEvent* event) {
  camera_.dolly(std::pow(0.87, event->angleDelta().y() / 120.0));
  cameraChanged();
  event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  constexpr double kStep = 12;
  const bool shift = event->modifiers() & Qt::ShiftModifier;
  const auto move = [&](double dx, double dy) {
    if (shift) {
      camera_.pan(dx, dy, height());
    } else {
      camera_.orbit(dx, dy);
    }
    cameraChanged();
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return move(-kStep, 0);
    case Qt::Key_Right:
      return move(kStep, 0);
    case Qt::Key_Up:
      return move(0, -kStep);
    case Qt::Key_Down:
      return move(0, kStep);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      camera_.dolly(0.9);
      return cameraChanged();
    case Qt::Key_Minus:
      camera_.dolly(1.0 / 0.9);
      return cameraChanged();
    case Qt::Key_Escape:
      if (handles_ && handles_->dragging()) return handles_->cancel();
      return event->ignore();
    default:
      event->ignore();
  }
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  requestFrame();
}

void Viewport::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  requestFrame();
}

}  // namespace heft
