#pragma once
// The surface that shows the 3D scene: asks for a picture when something changed, at most once an event loop turn, and
// turns the mouse into camera moves.
#include <QElapsedTimer>
#include <QPoint>
#include <QPointer>
#include <QTimer>
#include <QWidget>

#include "ui/robot_view/handles.h"
#include "ui/robot_view/orbit_camera.h"
#include "ui/robot_view/scene_renderer.h"

namespace heft {

class Viewport : public QWidget {
  Q_OBJECT
 public:
  explicit Viewport(QWidget* parent = nullptr);

  /// What stands in the scene; who changes it asks for a frame.
  SceneState& scene() { return scene_; }
  OrbitCamera& camera() { return camera_; }
  double aspect() const { return height() > 0 ? static_cast<double>(width()) / height() : 1.0; }

  /// What can be grabbed, before the mouse turns the view; null for nothing. Must outlive its use here.
  void setHandles(HandleSet* handles);
  HandleSet* handles() const { return handles_; }
  HandleSet::View handleView() const { return {camera_, QSizeF(size())}; }
  /// The same of the picture on the screen, which the camera may be ahead of.
  HandleSet::View shownView() const { return {picture_.camera, QSizeF(size())}; }
  /// Where what is labelled stands in the picture on the screen.
  const SceneState::Anchors& anchors() const { return picture_.anchors; }

  /// Draws soon, and comes back at once; several calls make one frame.
  void requestFrame();
  /// Draws the present state smoothly and waits for it.
  void renderNow();
  double lastFrameMilliseconds() const { return picture_.milliseconds; }

 signals:
  /// With each new picture: overlays follow its camera.
  void rendered();
  void cameraMoved();

 protected:
  void paintEvent(QPaintEvent* event) override;
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
  PictureOrder order(bool smooth) const;
  void show(ScenePicture picture);
  void cameraChanged();
  void showCursor();

  SceneState scene_;
  OrbitCamera camera_;
  SceneRenderer renderer_;
  ScenePicture picture_;  ///< On the screen
  QPointer<HandleSet> handles_;
  QTimer frame_;              ///< Gathers requests.
  QTimer settle_;             ///< After the last quick frame: one smooth one.
  QElapsedTimer sinceFrame_;  ///< Since the last quick one
  QPoint last_;
};

}  // namespace heft
