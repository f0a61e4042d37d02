#pragma once
// Numbers of the command line, read the same way in every locale.
#include <optional>
#include <string_view>
#include <vector>

namespace heft::cli {

/// "0.1,-2,3e-3": finite decimal numbers separated by commas, without spaces; nothing if anything else stands there.
std::optional<std::vector<double>> parseNumbers(std::string_view text);

}  // namespace heft::cli
