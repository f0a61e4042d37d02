#pragma once
// Bytes of unknown origin: read front to back, never past their end.
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/input_file.h"
#include "core/base/result.h"

namespace heft {

/// Walks over bytes in memory. After the first read past the end nothing remains, every read gives zeros and ok() is
/// false: a loop for as long as something remains ends there.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes, bool bigEndian = false) : bytes_(bytes), bigEndian_(bigEndian) {}

  bool ok() const { return ok_; }
  bool atEnd() const { return at_ >= bytes_.size(); }
  std::size_t position() const { return at_; }
  std::size_t remaining() const { return bytes_.size() - at_; }

  template <class T>
  T read() {
    static_assert(std::is_arithmetic_v<T>);
    const std::string_view raw = take(sizeof(T));
    if (raw.size() != sizeof(T)) return T{};
    std::array<char, sizeof(T)> copy;
    const bool swap = bigEndian_ != (std::endian::native == std::endian::big);
    for (std::size_t i = 0; i < sizeof(T); ++i) copy[i] = raw[swap ? sizeof(T) - 1 - i : i];
    return std::bit_cast<T>(copy);
  }

  /// The next `count` bytes; empty, not ok and at the end if there are fewer.
  std::string_view take(std::uint64_t count) {
    if (!ok_ || count > remaining()) {
      ok_ = false;
      at_ = bytes_.size();
      return {};
    }
    const std::string_view out = bytes_.substr(at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return out;
  }

  /// A string after its length of 32 bits.
  std::string_view text() { return take(read<std::uint32_t>()); }

  /// Skips to the next multiple of `size` counted from the beginning.
  void align(std::size_t size) { take((size - at_ % size) % size); }

 private:
  std::string_view bytes_;
  bool bigEndian_ = false;
  bool ok_ = true;
  std::size_t at_ = 0;
};

/// A file that is read piece by piece, so that it may be larger than the memory.
class ByteFile {
 public:
  static Result<ByteFile> open(const std::filesystem::path& path);

  std::uint64_t size() const { return size_; }
  /// Up to `count` bytes from `offset`; fewer at the file's end, none where reading fails.
  std::string read(std::uint64_t offset, std::uint64_t count) const;

 private:
  explicit ByteFile(InputFile file) : file_(std::move(file)), size_(file_.size().value_or(0)) {}

  InputFile file_;
  std::uint64_t size_;
};

/// Bytes of a file, or of the memory, a piece at a time: what is passed over is never read.
class ByteWindow {
 public:
  explicit ByteWindow(const ByteFile& file) : file_(&file), size_(file.size()) {}
  explicit ByteWindow(std::string_view bytes) : bytes_(bytes), size_(bytes.size()) {}

  std::uint64_t size() const { return size_; }
  /// `count` bytes from `offset`, fewer at the end. They hold until the next call.
  std::string_view view(std::uint64_t offset, std::uint64_t count);

 private:
  const ByteFile* file_ = nullptr;
  std::string read_;
  std::string_view bytes_;  ///< From at_ on.
  std::uint64_t at_ = 0;
  std::uint64_t size_ = 0;
};

}  // namespace heft
