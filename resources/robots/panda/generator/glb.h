#pragma once
// Writes binary glTF: one mesh, one primitive a part.
#include <string>
#include <vector>

#include "resources/robots/panda/generator/contour.h"

namespace heft::panda_maker {

enum class Material { shell, dark, metal, sensor };

struct Part {
  Material material;
  Surface surface;
};

/// The bytes of a .glb file. Coordinates are the link's own (z along the joint), as URDF viewers take them.
std::string glb(const std::string& name, const std::vector<Part>& parts);

}  // namespace heft::panda_maker
