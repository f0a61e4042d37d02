#include "core/import/bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "core/base/findings.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

namespace {

constexpr std::uint64_t kReadAhead = 8u << 10;  ///< [bytes] A dozen of a sensor's messages, little of a picture

}  // namespace

struct ByteFile::Descriptor {
  explicit Descriptor(int opened) : number(opened) {}
  ~Descriptor() { ::close(number); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number;
};

Result<ByteFile> ByteFile::open(const std::filesystem::path& path) {
  ByteFile out;
  const int number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (number < 0)
    return errorAt({displayName(path), 0, 0}, heft::say("the file cannot be opened."),
                   heft::say("Check its name and its permissions."));
  out.file_ = std::make_shared<const Descriptor>(number);
  struct stat status {};
  if (::fstat(number, &status) != 0 || !S_ISREG(status.st_mode))
    return errorAt({displayName(path), 0, 0}, heft::say("this is not a regular file."),
                   heft::say("Give a recording's file."));
  out.size_ = static_cast<std::uint64_t>(status.st_size);
  return out;
}

std::string ByteFile::read(std::uint64_t offset, std::uint64_t count) const {
  if (offset >= size_) return {};
  std::string out(static_cast<std::size_t>(std::min(count, size_ - offset)), '\0');
  std::size_t done = 0;
  while (done < out.size()) {
    const auto got = ::pread(file_->number, out.data() + done, out.size() - done, static_cast<off_t>(offset + done));
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  out.resize(done);
  return out;
}

std::string_view ByteWindow::view(std::uint64_t offset, std::uint64_t count) {
  if (offset >= size_) return {};
  count = std::min(count, size_ - offset);
  if (file_ != nullptr && (offset < at_ || offset + count > at_ + bytes_.size())) {
    read_ = file_->read(offset, std::max(count, kReadAhead));
    bytes_ = read_;
    at_ = offset;
  }
  return bytes_.substr(std::min<std::uint64_t>(offset - at_, bytes_.size()), count);
}

}  // namespace heft
