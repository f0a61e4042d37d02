#pragma once
// The room that the links of an arm take up, as points.
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_model.h"

namespace heft {

struct LinkBody {
  std::string name;  ///< The link's
  int link = 0;
  Eigen::Matrix3Xd points;  ///< On its surface, link axes [m]; their hull is at least as large as the body.
};

/// One a collision body; where a link states none, one of all that it looks like. `toolFrom`: what is fixed on beyond
/// this link is left out, because the tool's own shape takes its place. Fails where a mesh cannot be read.
Result<std::vector<LinkBody>> linkBodies(const RobotModel& robot, const std::optional<int>& toolFrom);

}  // namespace heft
