#include "core/base/file_replacement.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {
namespace {

constexpr int kMostLinks = 40;             ///< As many as Linux follows.
constexpr std::size_t kCopied = 1u << 20;  ///< [bytes] At a time

/// Where the links at `path` lead, also if nothing is there yet.
std::filesystem::path throughLinks(std::filesystem::path path) {
  std::error_code code;
  for (int k = 0; k < kMostLinks && std::filesystem::is_symlink(path, code); ++k) {
    const auto next = std::filesystem::read_symlink(path, code);
    if (code) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

/// 0, or errno.
int writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

Error cannotBeWritten(const std::filesystem::path& path, int reason) {
  return Error{heft::say("{} cannot be written: {}.", displayName(path), std::strerror(reason))};
}

/// A name that no other writer of any program uses at this time.
std::filesystem::path besideOf(const std::filesystem::path& target) {
  static std::atomic<unsigned> count{0};
  auto name = target;
  name += fmt::format(".{}-{}.part", ::getpid(), count++);
  return name;
}

}  // namespace

int flushToDisk(int descriptor) {
  while (::fsync(descriptor) != 0) {
    if (errno == EINTR) continue;
    return errno == EINVAL || errno == ENOTSUP || errno == EROFS ? 0 : errno;
  }
  return 0;
}

void flushFolderOf(const std::filesystem::path& file) {
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // A folder that may be written to, not read
  flushToDisk(descriptor);
  ::close(descriptor);
}

Result<FileReplacement> FileReplacement::begin(const std::filesystem::path& path) {
  FileReplacement out;
  out.named_ = path;
  out.target_ = throughLinks(path);
  std::error_code code;
  if (std::filesystem::is_symlink(out.target_, code)) return cannotBeWritten(path, ELOOP);
  struct stat old {};
  const bool exists = ::stat(out.target_.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) return Error{heft::say("{} is a folder, not a file.", displayName(path))};
  if (exists && !S_ISREG(old.st_mode)) return cannotBeWritten(path, EINVAL);
  if (exists && ::access(out.target_.c_str(), W_OK) != 0) return cannotBeWritten(path, errno);
  const auto temporary = besideOf(out.target_);
  ::unlink(temporary.c_str());  // Of a program that was killed and had the same number
  // Nobody may look into it who could not look into the old one.
  out.descriptor_ = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, exists ? 0600 : 0666);
  if (out.descriptor_ < 0) return cannotBeWritten(path, errno);
  out.temporary_ = temporary;
  if (exists) {
    // Another's file stays another's where the system lets us give it away; its permissions stay in any case.
    if (old.st_uid != ::geteuid() || old.st_gid != ::getegid())
      if (::fchown(out.descriptor_, old.st_uid, old.st_gid) != 0) errno = 0;
    if (::fchmod(out.descriptor_, old.st_mode & 07777) != 0) return cannotBeWritten(path, errno);
  }
  return out;
}

FileReplacement::FileReplacement(FileReplacement&& other) noexcept
    : named_(std::move(other.named_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

FileReplacement::~FileReplacement() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Error FileReplacement::failure(int reason) const { return cannotBeWritten(named_, reason); }

Result<bool> FileReplacement::write(std::string_view bytes) {
  if (const int reason = writeAll(descriptor_, bytes); reason != 0) return failure(reason);
  return true;
}

Result<bool> FileReplacement::commit() {
  if (const int reason = flushToDisk(descriptor_); reason != 0) return failure(reason);
  if (::close(std::exchange(descriptor_, -1)) != 0) return failure(errno);  // Network disks tell of a full one here.
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) return failure(errno);
  temporary_.clear();
  flushFolderOf(target_);
  return true;
}

Result<bool> createTextFile(const std::filesystem::path& path, std::string_view text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0 && errno == EEXIST)
    return Error{heft::say("{} already exists and was not overwritten.", displayName(path))};
  if (descriptor < 0) return cannotBeWritten(path, errno);
  int reason = writeAll(descriptor, text);
  if (reason == 0) reason = flushToDisk(descriptor);
  if (::close(descriptor) != 0 && reason == 0) reason = errno;
  if (reason != 0) {
    ::unlink(path.c_str());
    return cannotBeWritten(path, reason);
  }
  flushFolderOf(path);
  return true;
}

Result<bool> copyFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  const int source = ::open(from.c_str(), O_RDONLY | O_CLOEXEC);
  if (source < 0) return Error{heft::say("{} cannot be opened: {}.", displayName(from), std::strerror(errno))};
  const struct Guard {
    int descriptor;
    ~Guard() { ::close(descriptor); }
  } guard{source};
  auto copy = FileReplacement::begin(to);
  if (!copy) return copy.error();
  std::vector<char> bytes(kCopied);
  for (;;) {
    const auto got = ::read(source, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Error{heft::say("{} cannot be read: {}.", displayName(from), std::strerror(errno))};
    if (got == 0) return copy->commit();
    if (auto written = copy->write({bytes.data(), static_cast<std::size_t>(got)}); !written) return written;
  }
}

}  // namespace heft
