#include "core/recording/meta_file.h"

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

Result<nlohmann::json> mergedMeta(const std::filesystem::path& file, const nlohmann::json& changes) {
  nlohmann::json merged = nlohmann::json::object();
  if (std::filesystem::exists(file)) {
    auto there = readJsonFile(file);
    if (!there) return there.error();
    if (!there->is_object()) return Error{heft::say("{} is not a setup file.", displayName(file))};
    merged = std::move(*there);
  }
  merged.merge_patch(changes);
  return merged;
}

nlohmann::json toJson(const SensorMount& mount) {
  const auto list = [](const Vector3d& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
  return {{"parent", mount.parent}, {"xyz_m", list(mount.xyz)}, {"rpy_rad", list(mount.rpy)}};
}

}  // namespace heft
