#pragma once
// Lengths of a body written beside it in the 3D view, as in a drawing.
#include <QRectF>
#include <QString>
#include <utility>
#include <vector>

#include "ui/robot_view/handles.h"

class QPainter;

namespace heft {

struct DimensionLine {
  /// Edges of this length, S axes [m]; the least obstructed one is used.
  std::vector<std::pair<Vector3d, Vector3d>> edges;
  QString text;   ///< "64 mm"
  int tone = -1;  ///< 0, 1, 2: colour of an axis
  bool strong = false;
  int id = -1;  ///< Of the handle that changes this length; the number can then be typed in the picture.
};

/// A line's place in the picture [px].
struct PlacedDimension {
  const DimensionLine* line = nullptr;
  QPointF from, to;  ///< The edge
  QPointF away;      ///< Unit vector from the body
  QRectF label;
};

/// Labels stand free of each other where they can. Points into `lines`.
std::vector<PlacedDimension> placeDimensions(const std::vector<DimensionLine>& lines, const Isometry3d& X_BS,
                                             const HandleSet::View& view);
void paintDimensions(QPainter& painter, const std::vector<PlacedDimension>& placed);

}  // namespace heft
