#include "core/base/package_uri.h"

#include <charconv>
#include <cstdlib>
#include <vector>

namespace heft {
namespace {

namespace fs = std::filesystem;

bool isFile(const fs::path& path) {
  std::error_code problem;
  return fs::is_regular_file(path, problem);
}

std::optional<fs::path> ifFile(const fs::path& path) {
  if (isFile(path)) return path.lexically_normal();
  return std::nullopt;
}

std::vector<fs::path> foldersOf(const char* variable) {
  std::vector<fs::path> folders;
  const char* value = std::getenv(variable);
  if (!value) return folders;
  std::string_view rest(value);
  while (!rest.empty()) {
    const std::size_t end = rest.find(':');
    if (end != 0) folders.emplace_back(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  }
  return folders;
}

std::string percentDecoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, code, 16).ptr == text.data() + i + 3) {
      out += static_cast<char>(code);
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

std::optional<fs::path> inPackage(const fs::path& package, const fs::path& rest, const fs::path& baseFolder) {
  std::error_code problem;
  fs::path folder = fs::absolute(baseFolder.empty() ? fs::path(".") : baseFolder, problem).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  std::optional<fs::path> renamed;
  for (; folder != folder.root_path(); folder = folder.parent_path()) {
    if (folder.filename() == package) {
      if (auto found = ifFile(folder / rest)) return found;
    }
    if (auto found = ifFile(folder / package / rest)) return found;
    // A package whose folder was renamed (a downloaded archive, say) is recognised by its content.
    if (!renamed) renamed = ifFile(folder / rest);
  }
  for (const fs::path& entry : foldersOf("ROS_PACKAGE_PATH")) {
    if (entry.filename() == package) {
      if (auto found = ifFile(entry / rest)) return found;
    }
    if (auto found = ifFile(entry / package / rest)) return found;
    // One level of repositories that hold several packages, as in a catkin source folder.
    for (auto it = fs::directory_iterator(entry, problem); !problem && it != fs::directory_iterator();
         it.increment(problem)) {
      if (auto found = ifFile(it->path() / package / rest)) return found;
    }
  }
  for (const fs::path& prefix : foldersOf("AMENT_PREFIX_PATH")) {
    if (auto found = ifFile(prefix / "share" / package / rest)) return found;
  }
  return renamed;
}

}  // namespace

std::optional<fs::path> resolveUri(const std::string& uri, const fs::path& baseFolder) {
  if (uri.empty()) return std::nullopt;
  for (const std::string_view scheme : {"package://", "model://"}) {
    if (!std::string_view(uri).starts_with(scheme)) continue;
    const std::string_view path = std::string_view(uri).substr(scheme.size());
    const std::size_t slash = path.find('/');
    if (slash == 0 || slash == std::string_view::npos || slash + 1 == path.size()) return std::nullopt;
    return inPackage(path.substr(0, slash), path.substr(slash + 1), baseFolder);
  }
  if (std::string_view(uri).starts_with("file://")) return ifFile(percentDecoded(std::string_view(uri).substr(7)));
  return ifFile(baseFolder / uri);
}

}  // namespace heft
