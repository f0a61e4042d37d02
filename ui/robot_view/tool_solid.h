#pragma once
// A body of the tool's shape as faces to fill and edges to draw, in the body's own frame. Free of Qt and VTK.
#include <vector>

#include "core/mesh/mesh.h"
#include "core/payload/shape.h"

namespace heft {

struct ToolSolid {
  MeshPart faces;
  std::vector<std::vector<Vector3d>> edges;   ///< Polylines [m]
  std::vector<std::vector<Vector3d>> hollow;  ///< Edges of the inner side of a hollow body [m]
};

/// Of a mesh only what is loaded already (`body.mesh`); of a body with impossible numbers nothing.
ToolSolid makeToolSolid(const ShapeBody& body);

}  // namespace heft
