#pragma once
// A file that is open for reading, with errors that name it.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"

namespace heft {

/// Closed with its last copy. Threads may read at once, each where it likes.
class InputFile {
 public:
  /// Fails for folders and for what is not there or may not be read.
  static Result<InputFile> open(const std::filesystem::path& path);

  /// As messages name it.
  const std::string& name() const { return name_; }
  /// Bytes when it was opened; nothing for pipes and devices, which state none.
  std::optional<std::uint64_t> size() const { return size_; }
  /// Up to `count` bytes from `at`; fewer only where the file ends. Not for pipes.
  Result<std::size_t> readAt(std::uint64_t at, char* to, std::size_t count) const;
  /// Up to `count` of the bytes that follow those read so far; 0 at the end.
  Result<std::size_t> readNext(char* to, std::size_t count) const;

 private:
  InputFile(int descriptor, std::string name);
  Error cannotBeRead() const;

  std::shared_ptr<const int> descriptor_;
  std::string name_;
  std::optional<std::uint64_t> size_;
};

}  // namespace heft
