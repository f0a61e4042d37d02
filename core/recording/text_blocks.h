#pragma once
// Text in blocks that end with a line, so that several threads read it at once and none of it has to be in memory as a
// whole.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/input_file.h"
#include "core/base/result.h"

namespace heft {

class TextBlocks {
 public:
  static constexpr std::size_t kUsualSize = std::size_t{512} << 10;

  /// `text` must live as long. Each block has about `size` bytes.
  TextBlocks(std::string_view text, char newline, std::size_t size = kUsualSize);
  /// Of what the file had when it was opened, all from byte `from` on.
  TextBlocks(InputFile file, std::uint64_t from, char newline, std::size_t size = kUsualSize);

  std::size_t count() const { return static_cast<std::size_t>((end_ - begin_ + size_ - 1) / size_); }
  struct Block {
    std::string_view lines;
    std::uint64_t at = 0;  ///< Where they begin, in bytes from the beginning of the text or file
  };
  /// The lines that begin in the `i`-th part of the text, the last one as a whole; none where one line covers it.
  /// `room` holds them if they come from a file. Fails where the file cannot be read.
  Result<Block> block(std::size_t i, std::string& room) const;

 private:
  Result<std::string_view> part(std::uint64_t from, std::uint64_t to, std::string& room) const;

  std::string_view text_;
  std::optional<InputFile> file_;
  std::uint64_t begin_ = 0, end_ = 0;
  char newline_;
  std::size_t size_;
};

}  // namespace heft
