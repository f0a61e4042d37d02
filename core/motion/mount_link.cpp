#include "core/motion/mount_link.h"

#include <vector>

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

void mountOnFlange(RecordingMeta& meta, const RobotModel& robot, Findings& findings) {
  if (meta.mount.parent != SensorMount{}.parent || robot.findLink(meta.mount.parent) || robot.movingJoints().empty())
    return;
  int link = robot.joints()[static_cast<std::size_t>(robot.movingJoints().back())].childLink;
  // What hangs on it by fixed joints, and is named as a flange is.
  std::vector<int> fixed{link};
  for (std::size_t i = 0; i < fixed.size() && i < robot.joints().size() + 1; ++i)
    for (const auto& joint : robot.joints()) {
      if (joint.type != JointType::fixed || joint.parentLink != fixed[i]) continue;
      fixed.push_back(joint.childLink);
      const auto& name = robot.links()[static_cast<std::size_t>(joint.childLink)].name;
      if (name.ends_with("tool0") || name.ends_with("flange") || name.ends_with("ee_link")) link = joint.childLink;
    }
  meta.mount.parent = robot.links()[static_cast<std::size_t>(link)].name;
  findings.push_back(
      {Severity::warning,
       "mount_assumed",
       heft::say("The sensor's mounting is not stated; it is assumed to be at the origin of the robot's link \"{}\".",
                 meta.mount.parent),
       heft::say("State sensor.mount in the setup file."),
       {}});
}

}  // namespace heft
