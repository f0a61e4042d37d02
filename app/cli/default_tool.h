#pragma once
// What `heft simulate` carries when no payload file is given.
#include "core/payload/inertial_parameters.h"

namespace heft::cli {

/// A small gripper of 0.80 kg: a round body, a camera at its side and two fingers, in S axes. Exact sums of homogeneous
/// solids, so that it is physical and no axis is a symmetry axis.
Payload defaultTool();

}  // namespace heft::cli
