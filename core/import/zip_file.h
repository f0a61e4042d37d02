#pragma once
// ZIP archives (PKWARE's APPNOTE): members that are stored or deflated, found by the directory at the archive's end.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/import/compression.h"

namespace heft {

struct ZipMember {
  std::string name;
  unsigned method = 0;         ///< 0 stored, 8 deflated
  std::uint64_t packed = 0;    ///< [bytes]
  std::uint64_t unpacked = 0;  ///< [bytes] as stated
  std::uint64_t headerAt = 0;  ///< Of the member's own header.
};

/// Members in the order of the directory; empty if there is no sound directory.
std::vector<ZipMember> zipMembers(std::string_view archive);

/// The content, or its beginning where it is damaged or longer than `maxBytes`; stops soon after `progress` is
/// cancelled.
Unpacked readZipMember(std::string_view archive, const ZipMember& member, std::size_t maxBytes,
                       const Progress& progress);

}  // namespace heft
