#pragma once
// A pull on the tool in the 3D view: a spring from the tool to where it comes from, or an arrow with its direction.
#include <QString>

#include "ui/robot_view/handles.h"

class QPainter;

namespace heft {

struct PullMark {
  Vector3d anchor = Vector3d::Zero();  ///< Where it pulls from, B axes [m].
  QString title, note;                 ///< "Something pulls from here", "within 3 cm"
};

/// Where the far end stands in the picture.
QPointF pullPixel(const PullMark& mark, const Vector3d& tool, const HandleSet::View& view);
/// Without the words, which stand among the view's labels.
void paintPull(QPainter& painter, const PullMark& mark, const Vector3d& tool, const HandleSet::View& view);

}  // namespace heft
