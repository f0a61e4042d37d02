#pragma once
// The closest distance between arm, tool and room in the 3D view: a line between two points, and its words.
#include <QString>

#include "core/collision/clearance.h"
#include "ui/robot_view/handles.h"

class QPainter;

namespace heft {

/// In red where the two are nearer than their margin. Without the words, which stand among the view's labels.
void paintGap(QPainter& painter, const Nearest& gap, const HandleSet::View& view);

/// "23 mm", or "Too near: 8 mm".
QString gapTitle(const Nearest& gap);
/// Which bodies.
QString gapNote(const Nearest& gap);

}  // namespace heft
