#pragma once
// Draws the scene in a thread of its own: the window waits for no picture, and shows the newest there is.
#include <QImage>
#include <QOffscreenSurface>
#include <QThread>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "ui/robot_view/orbit_camera.h"
#include "ui/robot_view/scene_state.h"

class QOpenGLContext;

namespace heft {

struct Theme;

/// What a picture is to show.
struct PictureOrder {
  SceneState state;
  const Theme* theme = nullptr;
  OrbitCamera camera;
  QSize size;               ///< [widget pixels]
  double pixelRatio = 1.0;  ///< Device pixels a widget pixel
  bool smooth = false;      ///< Without a graphics card smoothing costs too much while things move; else always done.
  bool moving = false;  ///< Things move by themselves: the picture may come a little later, for the sake of the rest.
};

struct ScenePicture {
  QImage image;  ///< Null before the first, and where there is no OpenGL
  OrbitCamera camera;
  SceneState::Anchors anchors;
  bool smooth = false;
  double milliseconds = 0.0;  ///< That it took
};

class SceneRenderer : public QThread {
  Q_OBJECT
 public:
  explicit SceneRenderer(QObject* parent = nullptr);
  ~SceneRenderer() override;

  /// Soon; one that is not begun when the next comes is not drawn.
  void order(PictureOrder order);
  /// At once, and waits for it.
  ScenePicture drawNow(PictureOrder order);
  /// The newest picture, once.
  std::optional<ScenePicture> take();
  /// False: this computer offers no OpenGL, and no picture will come.
  bool works() const { return context_ != nullptr; }

 signals:
  /// There is a picture to take.
  void drawn();

 protected:
  void run() override;

 private:
  QOffscreenSurface surface_;
  std::unique_ptr<QOpenGLContext> context_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<PictureOrder> order_;
  std::optional<ScenePicture> picture_;
  std::uint64_t ordered_ = 0, done_ = 0;  ///< Numbers of the newest order, and of the newest that was drawn or dropped
  bool ending_ = false;
};

}  // namespace heft
