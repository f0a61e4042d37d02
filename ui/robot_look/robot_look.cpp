#include "ui/robot_look/robot_look.h"

#include <map>
#include <mutex>

#include "core/base/say.h"

namespace heft {

RobotLook loadLook(const RobotModel& robot, Findings& findings, const Progress& progress) {
  RobotLook look;
  std::map<std::filesystem::path, std::shared_ptr<const Mesh>> loaded;
  const auto& links = robot.links();
  for (std::size_t l = 0; l < links.size(); ++l) {
    progress(static_cast<double>(l) / static_cast<double>(links.size()), "Loading the robot's shape");
    if (progress.cancelled()) break;
    for (const Visual& visual : links[l].visuals) {
      LookPart part{static_cast<int>(l), visual, nullptr};
      if (visual.kind == Visual::Kind::mesh) {
        auto found = loaded.find(visual.file);
        if (found == loaded.end()) {
          auto mesh = loadMesh(visual.file);
          if (!mesh) {
            findings.push_back({Severity::warning,
                                "mesh_not_loaded",
                                heft::say("The shape of link {} is not shown: {}", links[l].name, mesh.error().message),
                                heft::say("The numbers do not depend on it."),
                                {}});
          }
          found =
              loaded.emplace(visual.file, mesh ? std::make_shared<const Mesh>(std::move(mesh).value()) : nullptr).first;
        }
        if (!found->second) continue;
        part.mesh = found->second;
      }
      look.parts.push_back(std::move(part));
    }
  }
  return look;
}

std::shared_ptr<const RobotLook> pandaLook(Findings& findings, const Progress& progress) {
  static std::mutex mutex;
  static std::shared_ptr<const RobotLook> kept;
  const std::lock_guard lock(mutex);
  if (kept) return kept;
  Findings found;
  auto look = std::make_shared<const RobotLook>(loadLook(RobotModel::panda(), found, progress));
  findings.insert(findings.end(), found.begin(), found.end());
  // An incomplete one is not kept: the next try may succeed.
  if (found.empty() && !progress.cancelled()) kept = look;
  return look;
}

}  // namespace heft
