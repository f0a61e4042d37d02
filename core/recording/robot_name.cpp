#include "core/recording/robot_name.h"

#include "core/base/findings.h"
#include "core/base/package_uri.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

Result<std::string> robotNamed(const std::string& text, const std::filesystem::path& folder, const std::string& where) {
  if (text == "panda") return text;
  const std::string remedy = heft::say("Write \"panda\", the path of a URDF, or null.");
  if (text.empty() || text.find('\0') != std::string::npos)
    return errorAt({where, 0, 0}, heft::say("\"{}\" names no file.", printable(text)), remedy);
  const std::filesystem::path path(text);
  if (path.extension() == ".xacro")
    return errorAt({where, 0, 0}, heft::say("\"{}\" is a xacro file.", printable(text)),
                   heft::say("Expand it to a URDF first: xacro in.xacro > out.urdf."));
  if (text.starts_with("package://") || text.starts_with("model://") || text.starts_with("file://")) {
    const auto found = resolveUri(text, folder);
    if (!found)
      return errorAt({where, 0, 0},
                     heft::say("\"{}\" was not found in {} or a folder above it, nor by ROS_PACKAGE_PATH or "
                               "AMENT_PREFIX_PATH.",
                               printable(text), displayName(folder.empty() ? std::filesystem::path(".") : folder)),
                     heft::say("Source the workspace that holds the package, or give the path of the URDF."));
    return std::filesystem::absolute(*found).lexically_normal().string();
  }
  if (!path.has_extension() && path.filename() == path)
    return errorAt({where, 0, 0}, heft::say("\"{}\" is not a robot that Heft knows.", printable(text)), remedy);
  const auto full = path.is_absolute() ? path : folder / path;
  std::error_code code;
  const auto absolute = std::filesystem::absolute(full, code);
  return (code ? full : absolute).lexically_normal().string();
}

}  // namespace heft
