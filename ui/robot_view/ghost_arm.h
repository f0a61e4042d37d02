#pragma once
// A second arm, translucent in the accent colour: a suggested motion, not the recorded one.
#include <vtkRenderer.h>

#include <vector>

#include "ui/robot_view/piece.h"

namespace heft {

struct Theme;

class GhostArm {
 public:
  struct Part {
    int link;
    Eigen::Matrix4d X_LV;  ///< With the mesh's scale.
    vtkPolyData* mesh;
  };
  explicit GhostArm(vtkRenderer* renderer);

  /// What the ghost is made of; shared with the arm itself.
  void setParts(const std::vector<Part>& parts);
  /// Where its links are, indexed as the robot's; empty hides it. Links that are where `arm` has them are not drawn.
  void setPoses(const std::vector<Isometry3d>& X_BL, const std::vector<Isometry3d>& arm);
  /// The way that it goes [m, B axes]; empty hides it.
  void setWay(const std::vector<Vector3d>& way);
  void restyle(const Theme& theme);

 private:
  struct Link {
    int link;
    Eigen::Matrix4d X_LV;
    Piece piece;
  };
  vtkRenderer* renderer_;
  std::vector<Link> links_;
  Piece tube_;
};

}  // namespace heft
