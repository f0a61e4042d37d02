#pragma once
// Which robot a setup file or an option names.
#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace heft {

/// For RecordingMeta::robot: "panda" as it is, or the absolute path of the URDF that `text` names, which may be
/// relative to `folder` or an address of ROS (package://PACKAGE/FILE, see resolveUri()). Fails for a xacro file, for a
/// package that is not found and for a word that is neither. `where` stands first in the error: "rec.meta.json: robot".
Result<std::string> robotNamed(const std::string& text, const std::filesystem::path& folder, const std::string& where);

}  // namespace heft
