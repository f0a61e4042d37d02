#pragma once
// Where the files lie that come with the program.
#include <filesystem>

namespace heft {

/// The folder that holds robots/: the environment's HEFT_DATA_DIR if it is set; else share/heft beside the program's
/// own bin folder (an installed Heft, wherever it was moved to); else the source tree's resources (a build that was
/// never installed). It is not checked that the last one exists.
std::filesystem::path dataFolder();

}  // namespace heft
