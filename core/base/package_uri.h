#pragma once
// Where the addresses lead by which ROS names files.
#include <filesystem>
#include <optional>
#include <string>

namespace heft {

/// Where a uri leads (package://, model://, file://, absolute or relative to `baseFolder`). A package is looked for
/// upwards from baseFolder, then in ROS_PACKAGE_PATH, then in AMENT_PREFIX_PATH. nullopt: no such file anywhere.
std::optional<std::filesystem::path> resolveUri(const std::string& uri, const std::filesystem::path& baseFolder);

}  // namespace heft
