#include "core/motion/mount_link.h"

#include "core/base/remedy.h"
#include "core/base/say.h"

namespace heft {

Result<int> mountLink(const SensorMount& mount, const RobotModel& robot) {
  if (const auto link = robot.findLink(mount.parent)) return *link;
  std::string names;
  for (const auto& link : robot.links()) names += (names.empty() ? "" : ", ") + link.name;
  return Error{heft::say("The sensor's mount names the link \"{}\", which the robot \"{}\" does not have.",
                         mount.parent, robot.name()) +
               " " + remedy(Remedy::mountSensor, names)};
}

}  // namespace heft
