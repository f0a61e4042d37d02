#include "core/robot/data_folder.h"

#include <cstdlib>

namespace heft {

namespace fs = std::filesystem;

fs::path dataFolder() {
  if (const char* fromEnvironment = std::getenv("HEFT_DATA_DIR"); fromEnvironment && *fromEnvironment) {
    return fromEnvironment;
  }
  std::error_code problem;
  const fs::path program = fs::read_symlink("/proc/self/exe", problem);
  if (!problem) {
    const fs::path installed = program.parent_path().parent_path() / "share" / "heft";
    if (fs::is_directory(installed / "robots", problem)) return installed;
  }
  return HEFT_RESOURCES_DIR;
}

}  // namespace heft
