#include "core/base/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

InputFile::InputFile(int descriptor, std::string name)
    : descriptor_(new int(descriptor),
                  [](const int* each) {
                    ::close(*each);
                    delete each;
                  }),
      name_(std::move(name)) {}

Error InputFile::cannotBeRead() const {
  return Error{heft::say("{} cannot be read: {}.", name_, std::strerror(errno))};
}

Result<InputFile> InputFile::open(const std::filesystem::path& path) {
  const auto name = displayName(path);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    if (errno == ENOENT) return Error{heft::say("{}: there is no such file.", name)};
    return Error{heft::say("{} cannot be opened: {}.", name, std::strerror(errno))};
  }
  InputFile out(descriptor, name);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return out.cannotBeRead();
  if (S_ISDIR(status.st_mode)) return Error{heft::say("{} is a folder, not a file.", name)};
  if (S_ISREG(status.st_mode)) out.size_ = static_cast<std::uint64_t>(status.st_size);
  return out;
}

Result<std::size_t> InputFile::readAt(std::uint64_t at, char* to, std::size_t count) const {
  std::size_t done = 0;
  while (done < count) {
    const auto got = ::pread(*descriptor_, to + done, count - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return cannotBeRead();
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

Result<std::size_t> InputFile::readNext(char* to, std::size_t count) const {
  for (;;) {
    const auto got = ::read(*descriptor_, to, count);
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) return cannotBeRead();
  }
}

}  // namespace heft
