#pragma once
// Lengths of a body written beside it in the 3D view, as in a drawing.
#include <QString>
#include <utility>
#include <vector>

#include "ui/robot_view/handles.h"

class QPainter;

namespace heft {

struct DimensionLine {
  /// Edges of this length, S axes [m]; the one that lies freest in the picture is taken.
  std::vector<std::pair<Vector3d, Vector3d>> edges;
  QString text;       ///< "64 mm"
  int tone = -1;      ///< 0, 1, 2: colour of an axis
  bool strong = false;
};

void paintDimensions(QPainter& painter, const std::vector<DimensionLine>& lines, const Isometry3d& X_BS,
                     const Vector3d& centre, const HandleSet::View& view);

}  // namespace heft
