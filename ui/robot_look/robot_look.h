#pragma once
// A robot's visible parts with their meshes in memory. Free of Qt and VTK, so that a job can load it.
#include <memory>
#include <vector>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/robot/robot_model.h"

namespace heft {

struct LookPart {
  int link = 0;
  Visual visual;
  std::shared_ptr<const Mesh> mesh;  ///< Null for a box, cylinder or sphere.
};

struct RobotLook {
  std::vector<LookPart> parts;
};

/// Loads every mesh once. A mesh that cannot be had is a finding and leaves a gap in the picture.
RobotLook loadLook(const RobotModel& robot, Findings& findings, const Progress& progress = {});

/// The project's own Panda; loaded on first use, then shared. Thread-safe.
std::shared_ptr<const RobotLook> pandaLook(Findings& findings, const Progress& progress = {});

}  // namespace heft
