#include "core/import/bytes.h"

#include <algorithm>

#include "core/base/findings.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

namespace {

constexpr std::uint64_t kReadAhead = 8u << 10;  ///< [bytes] A dozen of a sensor's messages, little of a picture

}  // namespace

Result<ByteFile> ByteFile::open(const std::filesystem::path& path) {
  auto file = InputFile::open(path);
  std::error_code none;
  if (!file && !std::filesystem::is_directory(path, none))
    return errorAt({displayName(path), 0, 0}, heft::say("the file cannot be opened."),
                   heft::say("Check its name and its permissions."));
  if (!file || !file->size())
    return errorAt({displayName(path), 0, 0}, heft::say("this is not a regular file."),
                   heft::say("Give a recording's file."));
  return ByteFile(std::move(*file));
}

std::string ByteFile::read(std::uint64_t offset, std::uint64_t count) const {
  if (offset >= size_) return {};
  std::string out(static_cast<std::size_t>(std::min(count, size_ - offset)), '\0');
  const auto got = file_.readAt(offset, out.data(), out.size());
  out.resize(got ? *got : 0);
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
