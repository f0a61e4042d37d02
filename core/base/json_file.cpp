#include "core/base/json_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <system_error>

namespace heft {

Result<nlohmann::json> parseJson(std::string_view text, const std::string& name) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t end = std::min(text.size(), error.byte > 0 ? error.byte - 1 : 0);
    const auto before = text.substr(0, end);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto lineStart = before.rfind('\n');
    const auto column = 1 + (lineStart == std::string_view::npos ? before.size() : before.size() - lineStart - 1);
    std::string reason = error.what();
    if (const auto colon = reason.rfind(": "); colon != std::string::npos) reason = reason.substr(colon + 2);
    return Error{fmt::format("{}:{}:{}: this is not valid JSON ({}).", name, line, column, reason)};
  }
}

Result<std::string> readTextFile(const std::filesystem::path& path, std::size_t maxBytes) {
  std::error_code ec;
  if (std::filesystem::is_directory(path, ec)) return Error{fmt::format("{} is a folder, not a file.", path.string())};
  const auto size = std::filesystem::file_size(path, ec);
  if (!ec && size > maxBytes)
    return Error{fmt::format("{} has {} MB; at most {} MB are expected here.", path.string(), size >> 20, maxBytes >> 20)};
  std::ifstream in(path, std::ios::binary);
  if (!in) return Error{fmt::format("{} cannot be opened: {}.", path.string(), std::strerror(errno))};
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (in.bad()) return Error{fmt::format("{} cannot be read: {}.", path.string(), std::strerror(errno))};
  return text;
}

Result<nlohmann::json> readJsonFile(const std::filesystem::path& path) {
  auto text = readTextFile(path);
  if (!text) return text.error();
  return parseJson(*text, path.string());
}

Result<bool> writeTextFile(const std::filesystem::path& path, std::string_view text) {
  if (path == "-") {
    std::cout << text << std::flush;
    if (!std::cout) return Error{"The output cannot be written to stdout."};
    return true;
  }
  std::error_code ec;
  if (std::filesystem::is_directory(path, ec)) return Error{fmt::format("{} is a folder, not a file.", path.string())};
  if (std::filesystem::exists(path, ec) && !std::filesystem::is_regular_file(path, ec)) {  // a pipe or /dev/null
    std::ofstream out(path, std::ios::binary);
    out << text << std::flush;
    if (!out) return Error{fmt::format("{} cannot be written: {}.", path.string(), std::strerror(errno))};
    return true;
  }
  auto temporary = path;
  temporary += fmt::format(".{}.part", ::getpid());
  {
    std::ofstream out(temporary, std::ios::binary);
    if (!out) return Error{fmt::format("{} cannot be written: {}.", path.string(), std::strerror(errno))};
    out << text << std::flush;
    if (!out) {
      const int reason = errno;
      out.close();
      std::filesystem::remove(temporary, ec);
      return Error{fmt::format("{} cannot be written: {}.", path.string(), std::strerror(reason))};
    }
  }
  std::filesystem::rename(temporary, path, ec);
  if (ec) {
    const auto reason = ec.message();
    std::filesystem::remove(temporary, ec);
    return Error{fmt::format("{} cannot be written: {}.", path.string(), reason)};
  }
  return true;
}

}  // namespace heft
