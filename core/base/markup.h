#pragma once
// Text inside SVG, HTML and XML.
#include <string>
#include <string_view>

namespace heft {

/// `text` with &, <, > and double quotes as entities: safe as content and as an attribute's value.
std::string escapedMarkup(std::string_view text);

}  // namespace heft
