#pragma once
// Everything that the generator writes.
#include <map>
#include <string>

namespace heft::panda_maker {

/// The URDF, from the table of joints.
std::string pandaUrdf();

/// File name (relative to resources/robots/panda) to content: the URDF and one mesh a link.
std::map<std::string, std::string> pandaFiles();

}  // namespace heft::panda_maker
