#pragma once
// The tool's shape as points on its surface.
#include <vector>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/payload/shape.h"

namespace heft {

/// Points whose hull is the body, one set a body, S axes [m]. Fails like sampleShape().
Result<std::vector<Eigen::Matrix3Xd>> outlinesOf(const Shape& shape, Findings& findings);

}  // namespace heft
