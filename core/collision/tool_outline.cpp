#include "core/collision/tool_outline.h"

#include "core/payload/shape_bound.h"

namespace heft {

Result<std::vector<Eigen::Matrix3Xd>> outlinesOf(const Shape& shape, Findings& findings) {
  std::vector<Eigen::Matrix3Xd> out;
  for (const ShapeBody& body : shape.bodies) {
    Shape one;
    one.bodies = {body};
    one.certainty = shape.certainty;
    const auto samples = sampleShape(one, findings);
    if (!samples) return samples.error();
    out.push_back(boundPoints(one, *samples));
  }
  return out;
}

}  // namespace heft
