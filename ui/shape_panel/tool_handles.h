#pragma once
// The tool in the 3D view while it is edited: what can be grabbed, what a drag makes of the shape, and which lengths
// are written beside it. Handles are in S axes.
#include <vector>

#include "core/payload/tool_sketch.h"
#include "ui/robot_view/dimension_lines.h"
#include "ui/robot_view/handles.h"

namespace heft {

enum class ToolMode { size, move, turn };

/// One body of the tool, or all of them.
inline constexpr int kWholeTool = -1;

/// Which bodies a picture moves and turns together: kWholeTool, or the selected one of several.
int movedBody(ToolPicture picture, int selected);

/// Where a body begins, S axes [m]: the middle of its end towards the sensor; a mesh's own origin.
Vector3d nearEnd(const ShapeBody& body);

/// Moves and turns bodies (`body` or kWholeTool); turning is about the near end of the first of them.
Shape shifted(const Shape& shape, int body, const Vector3d& by);
Shape turned(const Shape& shape, int body, const Matrix3d& R);

std::vector<Handle> toolHandles(const Shape& shape, ToolPicture picture, int selected, ToolMode mode);
/// The body that a handle belongs to.
int bodyOfHandle(int id);
/// Index of the measure that a handle changes; -1 for other handles.
int measureOfHandle(int id);
/// A handle that only chooses its body.
bool choosesBody(int id);
/// What dragging makes of the shape as it was when the drag began; in whole millimetres and degrees, a tenth if fine.
Shape dragTool(const Shape& start, ToolPicture picture, int selected, const HandleDrag& drag);

/// Lengths beside the tool; the one whose handle is `current` is strong.
std::vector<DimensionLine> toolDimensions(const Shape& shape, ToolPicture picture, int selected,
                                          std::optional<int> current);

}  // namespace heft
