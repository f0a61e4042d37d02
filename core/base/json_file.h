#pragma once
// Reading and writing JSON files with errors that name line and column.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/input_file.h"
#include "core/base/result.h"

namespace heft {

/// Parses text; `name` stands in the message ("rec.meta.json:3:17: ..."). Comments are not allowed.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& name);

/// Reads a whole JSON file of at most 64 MB.
Result<nlohmann::json> readJsonFile(const std::filesystem::path& path);

/// The whole content of a text file of at most `maxBytes`, or why it cannot be read. The limit also holds for pipes and
/// devices, which state no size.
Result<std::string> readTextFile(const std::filesystem::path& path, std::size_t maxBytes = 64u << 20);

/// All that follows what was read of the file so far.
Result<std::string> readRest(const InputFile& file, std::size_t maxBytes);

/// Writes through a temporary file beside the target and renames it, so that a crash leaves the old file whole.
/// "-" writes to stdout. The value true only says that it succeeded.
Result<bool> writeTextFile(const std::filesystem::path& path, std::string_view text);

}  // namespace heft
