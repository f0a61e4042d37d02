#pragma once
// A hash of bytes that is the same on every machine and in every version.
#include <cstdint>
#include <string_view>

namespace heft {

/// FNV-1a with 64 bits (Fowler, Noll, Vo).
inline std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

}  // namespace heft
