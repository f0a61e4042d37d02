#pragma once
// Unpacks the compressed parts of bags and MCAP files.
#include <string>
#include <string_view>

namespace heft {

enum class Compression { none, bz2, lz4, zstd };

struct Unpacked {
  std::string bytes;
  bool complete = false;  ///< False: damaged or cut off; `bytes` holds what came before.
};

/// bz2 stream, LZ4 frame or zstd frame; stops before the result exceeds `maxBytes`.
Unpacked unpack(std::string_view packed, Compression compression, std::size_t maxBytes);

/// True for the first bytes of a zstd frame.
bool looksLikeZstd(std::string_view bytes);

}  // namespace heft
