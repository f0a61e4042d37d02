#pragma once
// The OpenGL surface: renders when asked, at most once an event loop turn, and turns the mouse into camera moves.
#include <QVTKOpenGLNativeWidget.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <QElapsedTimer>
#include <QPoint>
#include <QPointer>
#include <QTimer>

#include "ui/robot_view/handles.h"
#include "ui/robot_view/orbit_camera.h"

namespace heft {

class Viewport : public QVTKOpenGLNativeWidget {
  Q_OBJECT
 public:
  explicit Viewport(QWidget* parent = nullptr);

  vtkRenderer* renderer() { return renderer_; }
  OrbitCamera& camera() { return camera_; }
  double aspect() const { return height() > 0 ? static_cast<double>(width()) / height() : 1.0; }
  /// Widget pixels of a point in B, or a point far outside if it lies behind the camera.
  QPointF toPixels(const Vector3d& point) const;

  /// What can be grabbed, before the mouse turns the view; null for nothing. Must outlive its use here.
  void setHandles(HandleSet* handles);
  HandleSet* handles() const { return handles_; }
  HandleSet::View handleView() const { return {camera_, QSizeF(size())}; }

  /// Renders soon; several calls make one frame.
  void requestFrame();
  /// Renders now, smoothly if `smooth`.
  void renderNow(bool smooth);
  double lastFrameMilliseconds() const { return lastFrame_; }

 signals:
  /// Before each frame: the place to bring the scene up to date.
  void aboutToRender();
  /// After each frame: overlays follow the camera.
  void rendered();
  void cameraMoved();

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void cameraChanged();
  void showCursor();

  vtkSmartPointer<vtkRenderer> renderer_;
  OrbitCamera camera_;
  QPointer<HandleSet> handles_;
  QTimer frame_;                   ///< Gathers requests.
  QTimer settle_;                  ///< After the last quick frame: one smooth one.
  QElapsedTimer sinceFrame_;       ///< Since the last quick one
  bool softwareRendering_ = true;  ///< Then smoothing costs too much while things move.
  bool asked_ = false;
  QPoint last_;
  double lastFrame_ = 0.0;
};

}  // namespace heft
