#include "ui/shape_panel/tool_handles.h"

#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/shape_panel/shape_text.h"

#include "core/math/degrees.h"

namespace heft {
namespace {

/// Handle ids: 32 a body; below 8 sizes (index of the measure), then move x, y, z and freely, turn x, y, z, choose.
constexpr int kIds = 32, kMove = 8, kFree = 11, kTurnIds = 12, kChoose = 16;
constexpr double kGap = 0.012;  ///< [m] of an arrow from the body it moves

double rounded(double value, double step) { return std::round(value / step) * step; }

Eigen::AlignedBox3d extentInSensor(const Shape& shape, int body) {
  if (body == kWholeTool) return extentOf(shape);
  Shape alone;
  alone.bodies = {shape.bodies[static_cast<std::size_t>(body)]};
  return extentOf(alone);
}

bool edited(ToolPicture picture, int selected, std::size_t body) {
  return picture != ToolPicture::several || static_cast<int>(body) == selected;
}

/// The measure whose arrow carries the letter of its axis: one per direction, on the body that reaches farthest.
bool hasArrow(ToolPicture picture, std::size_t body, int axis) {
  return picture != ToolPicture::gripper || (axis == 2) == (body == 1);
}

void addSizes(std::vector<Handle>& handles, const Shape& shape, ToolPicture picture, int selected) {
  for (std::size_t b = 0; b < shape.bodies.size(); ++b) {
    if (!edited(picture, selected, b)) continue;
    const ShapeBody& body = shape.bodies[b];
    const auto extent = extentOf(body);
    const auto measures = measuresOf(body);
    for (std::size_t m = 0; m < measures.size(); ++m) {
      Handle handle;
      handle.id = static_cast<int>(b) * kIds + static_cast<int>(m);
      const int axis = std::max(0, measures[m].axis);
      Vector3d at = extent.center();
      at(axis) = extent.max()(axis);
      if (measures[m].axis < 0) {  // The hole, on its rim at the far end.
        at = {0, measures[m].value / 2, extent.max().z()};
        handle.axis = body.X_SB.linear().col(1);
      } else {
        handle.axis = body.X_SB.linear().col(axis);
        handle.tone = axis;
        // The wider end of a cone is its base.
        if (body.kind == BodyKind::cone && axis == 0) at.z() = extent.min().z();
      }
      handle.arrow = measures[m].axis >= 0 && hasArrow(picture, b, axis);
      handle.point = body.X_SB * at;
      handle.tip = QStringLiteral("%1 %2").arg(lengthName(measures[m].length), millimetres(measures[m].value));
      handles.push_back(handle);
    }
  }
}

void addMoves(std::vector<Handle>& handles, const Shape& shape, int body) {
  const auto extent = extentInSensor(shape, body);
  if (extent.isEmpty()) return;
  const int first = std::max(0, body) * kIds;
  for (int axis = 0; axis < 3; ++axis) {
    Handle handle;
    handle.id = first + kMove + axis;
    handle.axis = Vector3d::Unit(axis);
    handle.point = extent.center();
    handle.point(axis) = extent.max()(axis) + kGap;
    handle.tone = axis;
    handle.tip = tipForMove(axis);
    handles.push_back(handle);
  }
  Handle free;
  free.id = first + kFree;
  free.way = Handle::Way::plane;
  free.point = extent.center();
  free.grabRadius = 0.45 * extent.sizes().minCoeff();
  free.tip = tipForMove(-1);
  handles.push_back(free);
}

void addTurns(std::vector<Handle>& handles, const Shape& shape, int body) {
  const auto extent = extentInSensor(shape, body);
  if (extent.isEmpty()) return;
  const Vector3d pivot = nearEnd(shape.bodies[static_cast<std::size_t>(std::max(0, body))]);
  const double radius = 0.04 + 0.5 * extent.sizes().maxCoeff();
  for (int axis = 0; axis < 3; ++axis) {
    Handle handle;
    handle.id = std::max(0, body) * kIds + kTurnIds + axis;
    handle.way = Handle::Way::circle;
    handle.axis = Vector3d::Unit(axis);
    handle.centre = pivot;
    handle.point = pivot + radius * (Vector3d::Unit((axis + 1) % 3) + Vector3d::Unit((axis + 2) % 3)).normalized();
    handle.tone = axis;
    handle.tip = tipForTurn(axis);
    handles.push_back(handle);
  }
}

}  // namespace

int movedBody(ToolPicture picture, int selected) { return picture == ToolPicture::several ? selected : kWholeTool; }

Vector3d nearEnd(const ShapeBody& body) {
  const auto extent = extentOf(body);
  if (body.kind == BodyKind::mesh || extent.isEmpty()) return body.X_SB.translation();
  return body.X_SB * Vector3d(extent.center().x(), extent.center().y(), extent.min().z());
}

Shape shifted(const Shape& shape, int body, const Vector3d& by) {
  Shape out = shape;
  for (std::size_t b = 0; b < out.bodies.size(); ++b)
    if (body == kWholeTool || body == static_cast<int>(b)) out.bodies[b].X_SB.translation() += by;
  return out;
}

Shape turned(const Shape& shape, int body, const Matrix3d& R) {
  Shape out = shape;
  if (out.bodies.empty()) return out;
  const Vector3d pivot = nearEnd(shape.bodies[static_cast<std::size_t>(std::max(0, body))]);
  for (std::size_t b = 0; b < out.bodies.size(); ++b) {
    if (body != kWholeTool && body != static_cast<int>(b)) continue;
    Isometry3d& X = out.bodies[b].X_SB;
    // Rounding of many small turns must not bend the axes.
    X.linear() = Quaterniond(R * X.linear()).normalized().toRotationMatrix();
    X.translation() = pivot + R * (X.translation() - pivot);
  }
  return out;
}

int bodyOfHandle(int id) { return id / kIds; }
int measureOfHandle(int id) { return id % kIds < kMove ? id % kIds : -1; }
bool choosesBody(int id) { return id % kIds == kChoose; }

std::vector<Handle> toolHandles(const Shape& shape, ToolPicture picture, int selected, ToolMode mode) {
  std::vector<Handle> handles;
  if (shape.bodies.empty()) return handles;
  const int moved = movedBody(picture, std::clamp(selected, 0, static_cast<int>(shape.bodies.size()) - 1));
  switch (mode) {
    case ToolMode::size:
      addSizes(handles, shape, picture, selected);
      break;
    case ToolMode::move:
      addMoves(handles, shape, moved);
      break;
    case ToolMode::turn:
      addTurns(handles, shape, moved);
      break;
  }
  if (picture != ToolPicture::several) return handles;
  for (std::size_t b = 0; b < shape.bodies.size(); ++b) {
    if (static_cast<int>(b) == selected) continue;
    const auto extent = extentInSensor(shape, static_cast<int>(b));
    if (extent.isEmpty()) continue;
    Handle handle;
    handle.id = static_cast<int>(b) * kIds + kChoose;
    handle.way = Handle::Way::plane;
    handle.point = extent.center();
    handle.grabRadius = 0.5 * extent.sizes().minCoeff();
    handle.shown = false;
    handle.tip = tipForBody(static_cast<int>(b));
    handles.push_back(handle);
  }
  return handles;
}

Shape dragTool(const Shape& start, ToolPicture picture, int selected, const HandleDrag& drag) {
  const int id = drag.handle.id % kIds;
  const auto body = static_cast<std::size_t>(bodyOfHandle(drag.handle.id));
  const double millimetre = drag.fine ? 1e-4 : 1e-3;
  if (body >= start.bodies.size()) return start;
  if (id < kMove) {
    const auto measures = measuresOf(start.bodies[body]);
    const auto m = static_cast<std::size_t>(id);
    if (m >= measures.size()) return start;
    // The knob is on one side: of a length that grows to both sides, it shows half.
    const bool oneSided = measures[m].axis == 2;
    const double wanted = measures[m].value + (oneSided ? 1.0 : 2.0) * drag.along;
    return resized(start, picture, body, m, std::max(1e-3, rounded(wanted, millimetre)));
  }
  const int moved = movedBody(picture, selected);
  if (id < kTurnIds) {
    const Vector3d from = nearEnd(start.bodies[static_cast<std::size_t>(std::max(0, moved))]);
    Vector3d to = from + drag.shift;
    for (int a = 0; a < 3; ++a)
      if (std::abs(drag.shift(a)) > 1e-9) to(a) = rounded(to(a), millimetre);
    return shifted(start, moved, to - from);
  }
  if (id < kChoose) {
    const double angle = rounded(drag.angle, (drag.fine ? 0.1 : 1.0) * kRadPerDegree);
    return turned(start, moved, rotationFromVector(angle * drag.handle.axis));
  }
  return start;
}

std::vector<DimensionLine> toolDimensions(const Shape& shape, ToolPicture picture, int selected,
                                          std::optional<int> current) {
  std::vector<DimensionLine> lines;
  for (std::size_t b = 0; b < shape.bodies.size(); ++b) {
    if (!edited(picture, selected, b)) continue;
    const ShapeBody& body = shape.bodies[b];
    const auto extent = extentOf(body);
    const auto measures = measuresOf(body);
    const bool round = body.kind != BodyKind::box && body.kind != BodyKind::plate;
    for (std::size_t m = 0; m < measures.size(); ++m) {
      const int axis = measures[m].axis;
      const bool strong = current && *current == static_cast<int>(b) * kIds + static_cast<int>(m);
      if (axis < 0) continue;
      // The widths of a gripper's fingers would crowd the picture; they are shown while they are dragged.
      if (picture == ToolPicture::gripper && !strong && ((b == 1 && axis != 2) || (b == 0 && axis == 0))) continue;
      DimensionLine line;
      line.tone = axis;
      line.strong = strong;
      line.id = static_cast<int>(b) * kIds + static_cast<int>(m);
      line.text = millimetres(measures[m].value);
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto add = [&](const Vector3d& middle, const Vector3d& half) {
        line.edges.emplace_back(body.X_SB * Vector3d(middle - half), body.X_SB * Vector3d(middle + half));
      };
      const Vector3d half = 0.5 * measures[m].value * Vector3d::Unit(axis);
      if (round && axis != 2) {
        // Across the ends, in two directions.
        const Vector3d other = 0.5 * measures[m].value * Vector3d::UnitY();
        for (const double z : {extent.min().z(), extent.max().z()}) {
          if (body.kind == BodyKind::cone && z > extent.min().z()) continue;
          const double at = body.kind == BodyKind::sphere ? 0.0 : z;
          add({0, 0, at}, half);
          add({0, 0, at}, other);
        }
      } else {
        for (const double su : {-1.0, 1.0}) {
          for (const double sv : {-1.0, 1.0}) {
            Vector3d middle = extent.center();
            middle(u) += 0.5 * su * extent.sizes()(u) * (round ? 0.7071 : 1.0);
            middle(v) += 0.5 * sv * extent.sizes()(v) * (round ? 0.7071 : 1.0);
            add(middle, half);
          }
        }
      }
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

}  // namespace heft
