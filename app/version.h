#pragma once
// What this build is, for --version and for the files that it writes.
#include <string>
#include <string_view>

namespace heft {

/// "0.2.0"
std::string_view version();
/// "heft 0.2.0", then the revision that it was built from and the libraries' versions in a line of their own.
std::string versionText(std::string_view program);

}  // namespace heft
