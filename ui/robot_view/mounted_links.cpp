#include "ui/robot_view/mounted_links.h"

#include <algorithm>

namespace heft {

std::vector<bool> linksBeyond(const RobotModel& robot, const std::string& mountLink) {
  std::vector<bool> beyond(robot.links().size(), false);
  const auto mount = robot.findLink(mountLink);
  if (!mount) return beyond;
  // Parents come before children, but not in every URDF: repeat until nothing is added.
  for (bool added = true; added;) {
    added = false;
    for (const Joint& joint : robot.joints()) {
      if (beyond[joint.childLink] || !(joint.parentLink == *mount || beyond[joint.parentLink])) continue;
      if (robot.links()[joint.childLink].name.find("sensor") != std::string::npos) continue;
      beyond[joint.childLink] = true;
      added = true;
    }
  }
  return beyond;
}

bool showsSensor(const RobotModel& robot, const RobotLook& look) {
  return std::any_of(look.parts.begin(), look.parts.end(), [&](const LookPart& part) {
    return robot.links()[part.link].name.find("sensor") != std::string::npos;
  });
}

}  // namespace heft
