#include "core/recording/text_blocks.h"

#include <algorithm>
#include <utility>

namespace heft {

namespace {

/// What is read beyond a block to find the end of its last line, before more is.
constexpr std::size_t kBeyond = std::size_t{4} << 10;

}  // namespace

TextBlocks::TextBlocks(std::string_view text, char newline, std::size_t size)
    : text_(text), end_(text.size()), newline_(newline), size_(size) {}

TextBlocks::TextBlocks(InputFile file, std::uint64_t from, char newline, std::size_t size)
    : file_(std::move(file)),
      begin_(from),
      end_(std::max(from, file_->size().value_or(0))),
      newline_(newline),
      size_(size) {}

Result<std::string_view> TextBlocks::part(std::uint64_t from, std::uint64_t to, std::string& room) const {
  const auto size = static_cast<std::size_t>(to - from);
  if (!file_) return text_.substr(static_cast<std::size_t>(from), size);
  room.resize(size);
  const auto got = file_->readAt(from, room.data(), size);
  if (!got) return got.error();
  return std::string_view(room).substr(0, *got);
}

Result<TextBlocks::Block> TextBlocks::block(std::size_t i, std::string& room) const {
  const std::uint64_t first = begin_ + i * size_, last = std::min<std::uint64_t>(first + size_, end_);
  // A line begins after a line break, so the byte before the block is looked at, too.
  const std::uint64_t from = i > 0 ? first - 1 : first;
  for (std::size_t beyond = kBeyond;; beyond *= 8) {
    const std::uint64_t to = std::min<std::uint64_t>(last + beyond, end_);
    const auto bytes = part(from, to, room);
    if (!bytes) return bytes.error();
    std::size_t begin = 0;
    if (i > 0) {
      const auto before = bytes->find(newline_);
      if (before == std::string_view::npos || from + before + 1 >= last) return Block{};
      begin = before + 1;
    }
    const auto own = std::min(bytes->size(), static_cast<std::size_t>(last - from));
    if (own == 0) return Block{};
    const auto stop = bytes->find(newline_, own - 1);
    const bool ends = stop == std::string_view::npos && (to == end_ || bytes->size() < to - from);
    if (stop != std::string_view::npos || ends)
      return Block{bytes->substr(begin, ends ? std::string_view::npos : stop + 1 - begin), from + begin};
  }
}

}  // namespace heft
