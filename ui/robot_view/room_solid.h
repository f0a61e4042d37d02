#pragma once
// Room, hulls and the smallest gap between them as the 3D view draws them. Free of Qt and VTK.
#include <vector>

#include "core/collision/clearance.h"
#include "core/collision/room.h"
#include "ui/robot_view/tool_solid.h"

namespace heft {

/// One an obstacle, base axes [m]. Of a plane a square about the base's foot on it.
std::vector<ToolSolid> roomSolids(const Room& room);

/// The sharp edges of a hull, on its link.
struct HullEdges {
  int link = 0;
  std::vector<std::vector<Vector3d>> edges;  ///< Link axes [m]
};
std::vector<HullEdges> hullEdges(const std::vector<HullSurface>& hulls);

}  // namespace heft
