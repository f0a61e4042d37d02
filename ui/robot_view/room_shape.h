#pragma once
// The room in the 3D view, translucent, and the hulls of arm and tool about the ghost.
#include <vtkRenderer.h>

#include <memory>
#include <vector>

#include "ui/robot_view/piece.h"
#include "ui/robot_view/room_solid.h"

namespace heft {

struct Theme;

class RoomShape {
 public:
  explicit RoomShape(vtkRenderer* renderer) : renderer_(renderer) {}

  /// Wants restyle() afterwards, as setHulls() does.
  void setRoom(const std::vector<ToolSolid>& solids);
  void setHulls(const std::vector<HullEdges>& hulls);
  /// Where the links are to which the hulls belong; empty hides them.
  void setPoses(const std::vector<Isometry3d>& X_BL);
  void restyle(const Theme& theme);

 private:
  struct Hull {
    int link;
    Piece edges;
  };
  vtkRenderer* renderer_;
  std::vector<Piece> faces_, edges_;  ///< Of the room
  std::vector<Hull> hulls_;
};

}  // namespace heft
