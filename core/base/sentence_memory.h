#pragma once
// What say() tells the memory of sentences (said_again.h). Private to core/base.
#include <fmt/format.h>

#include <string>

namespace heft {

void remember(const std::string& text, fmt::string_view pattern, const fmt::format_args& arguments);

}  // namespace heft
