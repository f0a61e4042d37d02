#include "ui/shape_panel/mesh_loading.h"

#include "core/payload/tool_sketch.h"

namespace heft {

Result<LoadedMesh> loadToolMesh(ShapeBody wanted) {
  LoadedMesh out;
  if (!wanted.mesh) {
    auto mesh = loadMesh(wanted.file);
    if (!mesh) return mesh.error();
    wanted.mesh = std::make_shared<const Mesh>(std::move(*mesh));
  }
  const double unit = wanted.unit;
  wanted.unit = 1.0;
  const auto extent = extentOf(wanted);
  out.longest = extent.isEmpty() ? 0.0 : extent.sizes().maxCoeff();
  out.unitGuessed = !(unit > 0);
  wanted.unit = out.unitGuessed ? likelyUnit(out.longest) : unit;
  out.body = wanted;
  Shape alone;
  alone.bodies = {wanted};
  if (auto samples = sampleShape(alone, out.findings); !samples) out.unusable = samples.error();
  return out;
}

}  // namespace heft
