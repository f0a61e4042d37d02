#pragma once
// Triangles from a field by dual contouring: one vertex a grid cell, on the surface where it is smooth and on the edge
// or corner where it is not, so that a coarse grid keeps sharp rims. Normals come from the field, not from the
// triangles.
#include <array>
#include <vector>

#include "resources/robots/panda/generator/field.h"

namespace heft::panda_maker {

struct Surface {
  std::vector<std::array<float, 3>> vertices;  ///< [m]
  std::vector<std::array<float, 3>> normals;   ///< Unit length, one per vertex; rims have a vertex for each side.
  std::vector<std::array<unsigned, 3>> triangles;
};

struct Box {
  Vec low, high;
};

/// How far normals may differ before an edge is kept sharp: moulded shells turn quickly without any, machined parts
/// have bevels of a few degrees.
enum class Edges { soft, crisp };

/// The zero surface of `solid` inside `box`, which must hold all of it, with cells of edge `cell` [m]. Triangles all of
/// whose corners lie deeper than 1 mm inside `hidden` are left out (null: none).
Surface contour(const Field& solid, const Box& box, double cell, Edges edges, const Field& hidden = nullptr);

}  // namespace heft::panda_maker
