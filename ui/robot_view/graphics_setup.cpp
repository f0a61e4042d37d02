#include "ui/robot_view/graphics_setup.h"

#include <vtkObject.h>

#include <QSurfaceFormat>

namespace heft {

void prepareGraphics() {
  // What VTK's shaders need; it keeps depth and samples in buffers of its own.
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
  // VTK prints to stderr what a user can do nothing about.
  vtkObject::GlobalWarningDisplayOff();
}

}  // namespace heft
