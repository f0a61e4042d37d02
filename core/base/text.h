#pragma once
// Text of unknown origin made fit for a message: always valid UTF-8, one line, of bounded length.
#include <filesystem>
#include <string>
#include <string_view>

namespace heft {

/// `text` with every control character, line break and invalid UTF-8 byte replaced by U+FFFD; what follows the first
/// `maxBytes` bytes becomes an ellipsis (never cutting inside a character).
std::string printable(std::string_view text, std::size_t maxBytes = 60);

/// A path as it should stand in messages and in JSON, which both need valid UTF-8. Equal to path.string() for every
/// name that is valid UTF-8; not meant for opening the file again.
std::string displayName(const std::filesystem::path& path);

}  // namespace heft
