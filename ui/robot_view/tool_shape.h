#pragma once
// The user's tool in the 3D view: translucent bodies with edges, on the sensor.
#include <vtkRenderer.h>

#include <vector>

#include "core/payload/shape.h"
#include "ui/robot_view/piece.h"

namespace heft {

class ToolShape {
 public:
  explicit ToolShape(vtkRenderer* renderer) : renderer_(renderer) {}

  /// `selected` is drawn stronger than the others; -1: all alike.
  void setBodies(const std::vector<ShapeBody>& bodies, int selected);
  void setPose(const Isometry3d& X_BS);
  void setShown(bool shown);
  void restyle();
  bool empty() const { return bodies_.empty(); }
  /// Some points of its surface, S axes [m].
  const std::vector<Vector3d>& points() const { return points_; }

 private:
  struct Body {
    ShapeBody shape;
    Piece faces, edges, hollow;
  };
  void place();

  vtkRenderer* renderer_;
  std::vector<Body> bodies_;
  std::vector<Vector3d> points_;
  Isometry3d X_BS_ = Isometry3d::Identity();
  int selected_ = -1;
  bool shown_ = true;
};

}  // namespace heft
