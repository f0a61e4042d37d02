#include "ui/robot_view/scene_renderer.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <chrono>

#include "ui/robot_view/scene3d.h"

namespace heft {
namespace {

constexpr double kPause = 0.5;  ///< Of the time that a picture took, where drawing takes the processor's.

/// VTK's half, in the drawing thread while its context is current.
class Studio {
 public:
  explicit Studio(QOpenGLContext& context) {
    window_->SetIsCurrent(true);
    window_->SetSupportsOpenGL(1);
    window_->SetIsDirect(1);
    window_->SetMapped(1);
    window_->SetFrameBlitModeToNoBlit();
    window_->AddRenderer(renderer_);
    scene_ = std::make_unique<Scene3d>(renderer_);
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QString hardware = QString::fromLatin1(name != nullptr ? name : "");
    software_ = hardware.contains("llvmpipe") || hardware.contains("softpipe") || hardware.contains("SWR");
  }
  ~Studio() {
    scene_.reset();
    window_->Finalize();
  }

  /// No graphics card: drawing takes every core there is.
  bool software() const { return software_; }

  ScenePicture draw(const PictureOrder& order) {
    QElapsedTimer clock;
    clock.start();
    const QSize size = (QSizeF(order.size) * order.pixelRatio).toSize();
    const bool smooth = order.smooth || !software_;
    window_->SetSize(size.width(), size.height());
    window_->SetMultiSamples(smooth ? 4 : 0);
    scene_->show(order.state, *order.theme);
    scene_->applyCamera(order.camera);
    window_->Render();
    ScenePicture picture;
    window_->GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, 0, pixels_);
    // From the lower edge upwards, as OpenGL has it.
    picture.image =
        QImage(pixels_->GetPointer(0), size.width(), size.height(), 4 * size.width(), QImage::Format_RGBX8888)
            .mirrored()
            .convertToFormat(QImage::Format_RGB32);
    picture.image.setDevicePixelRatio(order.pixelRatio);
    picture.camera = order.camera;
    picture.anchors = order.state.anchors();
    picture.smooth = smooth;
    picture.milliseconds = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    return picture;
  }

 private:
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_ = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  vtkSmartPointer<vtkRenderer> renderer_ = vtkSmartPointer<vtkRenderer>::New();
  vtkSmartPointer<vtkUnsignedCharArray> pixels_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
  std::unique_ptr<Scene3d> scene_;
  bool software_ = true;
};

}  // namespace

SceneRenderer::SceneRenderer(QObject* parent) : QThread(parent) {
  surface_.create();
  context_ = std::make_unique<QOpenGLContext>();
  context_->setFormat(surface_.requestedFormat());
  if (!surface_.isValid() || !context_->create()) {
    context_.reset();
    return;
  }
  context_->moveToThread(this);
  start();
}

SceneRenderer::~SceneRenderer() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  wait();
}

void SceneRenderer::order(PictureOrder order) {
  if (!works() || order.size.width() < 2 || order.size.height() < 2) return;
  {
    const std::lock_guard lock(mutex_);
    order_ = std::move(order);
    ++ordered_;
  }
  changed_.notify_all();
}

ScenePicture SceneRenderer::drawNow(PictureOrder wanted) {
  if (!works() || wanted.size.width() < 2 || wanted.size.height() < 2) return {};
  order(std::move(wanted));
  std::unique_lock lock(mutex_);
  const std::uint64_t number = ordered_;
  changed_.wait(lock, [&] { return done_ >= number; });
  ScenePicture picture = std::move(*picture_);
  picture_.reset();
  return picture;
}

std::optional<ScenePicture> SceneRenderer::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(picture_, std::nullopt);
}

void SceneRenderer::run() {
  context_->makeCurrent(&surface_);
  auto studio = std::make_unique<Studio>(*context_);
  std::unique_lock lock(mutex_);
  auto rested = std::chrono::steady_clock::now();
  while (true) {
    changed_.wait(lock, [&] { return ending_ || order_; });
    if (studio->software()) changed_.wait_until(lock, rested, [&] { return ending_ || !order_->moving; });
    if (ending_) break;
    const PictureOrder order = std::move(*order_);
    order_.reset();
    const std::uint64_t number = ordered_;
    lock.unlock();
    ScenePicture picture = studio->draw(order);
    rested = std::chrono::steady_clock::now() +
             std::chrono::microseconds(static_cast<int>(kPause * 1e3 * picture.milliseconds));
    lock.lock();
    picture_ = std::move(picture);
    done_ = number;
    changed_.notify_all();
    emit drawn();
  }
  studio.reset();
  context_->doneCurrent();
  // Its thread ends here, so must it.
  context_.reset();
}

}  // namespace heft
