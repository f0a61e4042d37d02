#pragma once
// A CAD file as the tool's body: read, measured, its unit guessed, and tried whether a volume can be had. Free of Qt,
// for a job.
#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/payload/shape.h"

namespace heft {

struct LoadedMesh {
  ShapeBody body;        ///< With mesh and unit.
  double longest = 0.0;  ///< Side of the bounding box, in the file's numbers.
  bool unitGuessed = false;
  Findings findings;              ///< What was repaired or looks odd.
  std::optional<Error> unusable;  ///< No volume, or an impossible size: the body cannot be a shape like this.
};

/// `wanted` names the file; a unit of 0 is guessed; a mesh already in it is taken instead of the file. An error if the
/// file cannot be read.
Result<LoadedMesh> loadToolMesh(ShapeBody wanted);

}  // namespace heft
