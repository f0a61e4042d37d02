#include "ui/robot_view/graphics_setup.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkObject.h>
#include <QSurfaceFormat>

namespace heft {

void prepareGraphics() {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  // VTK prints to stderr what a user can do nothing about.
  vtkObject::GlobalWarningDisplayOff();
}

}  // namespace heft
