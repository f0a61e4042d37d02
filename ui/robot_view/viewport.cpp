#include "ui/robot_view/viewport.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkMatrix4x4.h>
#include <vtkRendererCollection.h>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QWheelEvent>

#include <cmath>

namespace heft {
namespace {

constexpr int kRest = 160;     ///< [ms] without a frame: what moved is at rest, and worth a smooth frame.
constexpr int kSlowest = 700;  ///< [ms] Frames further apart do not belong to one motion.

}  // namespace

Viewport::Viewport(QWidget* parent) : QVTKOpenGLNativeWidget(parent), renderer_(vtkSmartPointer<vtkRenderer>::New()) {
  auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  window->SetMultiSamples(0);
  setRenderWindow(window);
  window->AddRenderer(renderer_);
  // Our own mouse handling replaces VTK's interactor styles.
  setEnableHiDPI(true);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(false);
  frame_.setSingleShot(true);
  frame_.setInterval(0);
  connect(&frame_, &QTimer::timeout, this, [this] { renderNow(false); });
  settle_.setSingleShot(true);
  sinceFrame_.start();
  connect(&settle_, &QTimer::timeout, this, [this] { renderNow(true); });
}

QPointF Viewport::toPixels(const Vector3d& point) const {
  vtkMatrix4x4* matrix = renderer_->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect(), -1, 1);
  const double in[4] = {point.x(), point.y(), point.z(), 1.0};
  double out[4];
  matrix->MultiplyPoint(in, out);
  if (out[3] <= 1e-9) return {-1e6, -1e6};
  return {(out[0] / out[3] + 1) / 2 * width(), (1 - out[1] / out[3]) / 2 * height()};
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

void Viewport::requestFrame() {
  if (!frame_.isActive()) frame_.start();
}

void Viewport::renderNow(bool smooth) {
  frame_.stop();
  if (!isValid() || width() < 2 || height() < 2) return;
  emit aboutToRender();
  if (!asked_) {
    asked_ = true;
    makeCurrent();
    const auto* name = reinterpret_cast<const char*>(context()->functions()->glGetString(GL_RENDERER));
    const QString renderer = QString::fromLatin1(name != nullptr ? name : "");
    softwareRendering_ = renderer.contains("llvmpipe") || renderer.contains("softpipe") || renderer.contains("SWR");
  }
  renderWindow()->SetMultiSamples(smooth || !softwareRendering_ ? 4 : 0);
  QElapsedTimer clock;
  clock.start();
  renderWindow()->Render();
  lastFrame_ = static_cast<double>(clock.nsecsElapsed()) / 1e6;
  update();
  emit rendered();
  if (smooth) {
    settle_.stop();
  } else {
    // Where frames come slowly one after another, things have not come to rest between two of them.
    const auto gap = static_cast<int>(std::min<qint64>(sinceFrame_.restart(), kSlowest));
    settle_.start(gap < kSlowest ? std::max(kRest, 3 * gap) : kRest);
  }
}

bool Viewport::event(QEvent* event) {
  switch (event->type()) {
    // VTK's own widget would hand these to its interactor first.
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return QOpenGLWidget::event(event);
    default:
      return QVTKOpenGLNativeWidget::event(event);
  }
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
  QVTKOpenGLNativeWidget::leaveEvent(event);
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
  QVTKOpenGLNativeWidget::resizeEvent(event);
  requestFrame();
}

void Viewport::showEvent(QShowEvent* event) {
  QVTKOpenGLNativeWidget::showEvent(event);
  requestFrame();
}

}  // namespace heft
