#pragma once
// Unpacks the compressed parts of bags and MCAP files.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/progress.h"

namespace heft {

enum class Compression { none, bz2, lz4, zstd };

struct Unpacked {
  std::string bytes;
  bool complete = false;  ///< False: damaged or cut off; `bytes` holds what came before.

  /// The beginning of `block`, as far as `maxBytes` allow; false where that is not all.
  bool add(std::string_view block, std::size_t maxBytes) {
    const auto room = maxBytes - bytes.size();
    bytes += block.substr(0, room);
    return block.size() <= room;
  }
};

/// bz2 stream, LZ4 frame or zstd frame; stops at `maxBytes`, and soon after `progress` is cancelled.
Unpacked unpack(std::string_view packed, Compression compression, std::size_t maxBytes, const Progress& progress);

/// What one file may unpack to in all: 64 times its size and 1 GB. Numbers of sensors hardly shrink to a tenth; more is
/// a file that was made to fill the memory.
class UnpackBudget {
 public:
  explicit UnpackBudget(std::uint64_t fileSize) : left_(64 * fileSize + (std::uint64_t{1} << 30)) {}
  /// The most that the next part may unpack to, itself no more than `most`.
  std::size_t most(std::size_t most) const { return static_cast<std::size_t>(std::min<std::uint64_t>(left_, most)); }
  /// False once all is spent.
  bool spend(std::uint64_t bytes) {
    left_ -= std::min(left_, bytes);
    return left_ > 0;
  }

 private:
  std::uint64_t left_ = 0;
};

/// That the rest of a file was not read, as it unpacks to too much.
std::string budgetText(std::uint64_t fileSize);

/// True for the first bytes of a zstd frame.
bool looksLikeZstd(std::string_view bytes);

}  // namespace heft
