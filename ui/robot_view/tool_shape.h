#pragma once
// The user's tool in the 3D view: translucent bodies with edges, on the sensor.
#include <vtkRenderer.h>

#include <vector>

#include "ui/robot_view/piece.h"
#include "ui/robot_view/scene_state.h"

namespace heft {

struct Theme;

class ToolShape {
 public:
  explicit ToolShape(vtkRenderer* renderer) : renderer_(renderer) {}

  /// `selected` is drawn stronger than the others; -1: all alike. Wants restyle() afterwards.
  void setBodies(const std::vector<SceneState::ToolBody>& bodies, int selected);
  void setPose(const Isometry3d& X_BS);
  void setShown(bool shown);
  void restyle(const Theme& theme);

 private:
  struct Body {
    SceneState::ToolBody shape;
    Piece faces, edges, hollow;
  };
  void place();

  vtkRenderer* renderer_;
  std::vector<Body> bodies_;
  Isometry3d X_BS_ = Isometry3d::Identity();
  int selected_ = -1;
  bool shown_ = true;
};

}  // namespace heft
