#include "core/base/json_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <system_error>

#include "core/base/file_replacement.h"
#include "core/base/input_file.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

namespace {

/// Deeper nesting is no file of ours, and would exhaust the stack of whoever walks or prints the value.
constexpr int kMaxDepth = 200;

int nestingDepth(std::string_view text) {
  int depth = 0;
  int deepest = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return deepest;
}

}  // namespace

Result<nlohmann::json> parseJson(std::string_view text, const std::string& name) {
  if (nestingDepth(text) > kMaxDepth)
    return Error{heft::say("{}: this JSON is nested more than {} levels deep.", name, kMaxDepth)};
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t end = std::min(text.size(), error.byte > 0 ? error.byte - 1 : 0);
    const auto before = text.substr(0, end);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto lineStart = before.rfind('\n');
    const auto column = 1 + (lineStart == std::string_view::npos ? before.size() : before.size() - lineStart - 1);
    // what() is "[json.exception.parse_error.101] parse error at line 1, column 2: <reason>".
    std::string reason = error.what();
    if (const auto colon = reason.find(": "); colon != std::string::npos) reason = reason.substr(colon + 2);
    reason = printable(reason, 200);
    return Error{heft::say("{}:{}:{}: this is not valid JSON ({}).", name, line, column, reason)};
  } catch (const nlohmann::json::exception& error) {  // a number that no double holds
    return Error{heft::say("{}: this JSON cannot be used ({}).", name, printable(error.what(), 200))};
  }
}

Result<std::string> readTextFile(const std::filesystem::path& path, std::size_t maxBytes) {
  const auto file = InputFile::open(path);
  if (!file) return file.error();
  return readRest(*file, maxBytes);
}

Result<std::string> readRest(const InputFile& file, std::size_t maxBytes) {
  const std::size_t size = file.size().value_or(0);
  if (size > maxBytes)
    return Error{heft::say("{} has {} MB; at most {} MB can be read.", file.name(), size >> 20, maxBytes >> 20)};

  // One byte more than the file's size: the read that meets the end needs no second buffer. Files that state no size
  // (pipes, /proc) and files that still grow are read on, up to the limit.
  std::string text(std::max<std::size_t>(size + 1, 1u << 12), '\0');
  std::size_t used = 0;
  for (;;) {
    if (used == text.size()) text.resize(std::min(2 * text.size(), maxBytes + 1));
    const auto got = file.readNext(text.data() + used, text.size() - used);
    if (!got) return got.error();
    if (*got == 0) break;
    used += *got;
    if (used > maxBytes)
      return Error{heft::say("{} has more than the {} MB that can be read.", file.name(), maxBytes >> 20)};
  }
  text.resize(used);
  return text;
}

Result<nlohmann::json> readJsonFile(const std::filesystem::path& path) {
  auto text = readTextFile(path);
  if (!text) return text.error();
  return parseJson(*text, displayName(path));
}

Result<bool> writeTextFile(const std::filesystem::path& path, std::string_view text) {
  if (path == "-") {
    std::cout << text << std::flush;
    if (!std::cout) return Error{heft::say("The output cannot be written to stdout.")};
    return true;
  }
  std::error_code ec;
  if (std::filesystem::exists(path, ec) && !std::filesystem::is_regular_file(path, ec) &&
      !std::filesystem::is_directory(path, ec)) {  // a pipe or /dev/null
    std::ofstream out(path, std::ios::binary);
    out << text << std::flush;
    if (!out) return Error{heft::say("{} cannot be written: {}.", displayName(path), std::strerror(errno))};
    return true;
  }
  auto file = FileReplacement::begin(path);
  if (!file) return file.error();
  if (auto written = file->write(text); !written) return written;
  return file->commit();
}

}  // namespace heft
