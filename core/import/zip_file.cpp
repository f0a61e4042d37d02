#include "core/import/zip_file.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "core/import/bytes.h"

namespace heft {

namespace {

constexpr std::string_view kEndMagic("PK\5\6", 4);
constexpr std::string_view kEntryMagic("PK\1\2", 4);
constexpr std::string_view kLocalMagic("PK\3\4", 4);
constexpr std::size_t kLongestComment = 65535;
constexpr std::size_t kMostMembers = 4096;
constexpr std::uint32_t kIn64 = 0xFFFFFFFFu;  ///< The number stands in the entry's extra field, with 64 bits.

/// Sizes and place from the extra field of ZIP64, as far as the entry leaves them to it.
void readWide(std::string_view extra, ZipMember& member) {
  ByteReader reader(extra);
  while (reader.remaining() >= 4) {
    const auto id = reader.read<std::uint16_t>();
    const auto content = reader.take(reader.read<std::uint16_t>());
    if (!reader.ok() || id != 1) continue;
    ByteReader wide(content);
    for (auto* const number : {&member.unpacked, &member.packed, &member.headerAt})
      if (*number == kIn64 && wide.remaining() >= 8) *number = wide.read<std::uint64_t>();
    return;
  }
}

}  // namespace

std::vector<ZipMember> zipMembers(std::string_view archive) {
  const auto from = archive.size() > kLongestComment + 22 ? archive.size() - kLongestComment - 22 : 0;
  const auto end = archive.substr(from).rfind(kEndMagic);
  if (end == std::string_view::npos) return {};
  ByteReader tail(archive.substr(from + end));
  tail.take(10);
  tail.read<std::uint16_t>();  // members
  tail.read<std::uint32_t>();  // size of the directory
  const auto start = tail.read<std::uint32_t>();
  if (!tail.ok() || start >= archive.size()) return {};
  ByteReader reader(archive.substr(start));
  std::vector<ZipMember> out;
  while (out.size() < kMostMembers && reader.take(4) == kEntryMagic) {
    ZipMember member;
    reader.take(6);
    member.method = reader.read<std::uint16_t>();
    reader.take(8);
    member.packed = reader.read<std::uint32_t>();
    member.unpacked = reader.read<std::uint32_t>();
    const auto nameLength = reader.read<std::uint16_t>();
    const auto extraLength = reader.read<std::uint16_t>();
    const auto commentLength = reader.read<std::uint16_t>();
    reader.take(8);
    member.headerAt = reader.read<std::uint32_t>();
    member.name = reader.take(nameLength);
    readWide(reader.take(extraLength), member);
    reader.take(commentLength);
    if (!reader.ok()) break;
    out.push_back(std::move(member));
  }
  return out;
}

Unpacked readZipMember(std::string_view archive, const ZipMember& member, std::size_t maxBytes,
                       const Progress& progress) {
  if (member.headerAt >= archive.size()) return {};
  ByteReader reader(archive.substr(member.headerAt));
  if (reader.take(4) != kLocalMagic) return {};
  reader.take(22);
  const auto nameLength = reader.read<std::uint16_t>();
  const auto extraLength = reader.read<std::uint16_t>();
  reader.take(nameLength);
  reader.take(extraLength);
  if (!reader.ok()) return {};
  const auto packed = reader.take(static_cast<std::size_t>(std::min<std::uint64_t>(member.packed, reader.remaining())));
  Unpacked out;
  if (member.method == 0) {
    out.bytes = packed.substr(0, maxBytes);
    out.complete = packed.size() == member.packed && out.bytes.size() == packed.size();
    return out;
  }
  if (member.method != 8 || packed.size() > std::numeric_limits<unsigned>::max()) return {};
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return {};
  // No deflated byte gives more (zlib's own figure), whatever the directory says.
  constexpr std::uint64_t kMostOfAByte = 1032;
  const auto expected = std::min<std::uint64_t>(member.unpacked, kMostOfAByte * packed.size());
  out.bytes.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(expected, maxBytes)));
  std::string block(256u << 10, '\0');
  stream.next_in =
      reinterpret_cast<unsigned char*>(const_cast<char*>(packed.data()));  // the library does not write to it
  stream.avail_in = static_cast<unsigned>(packed.size());
  while (!progress.cancelled()) {
    stream.next_out = reinterpret_cast<unsigned char*>(block.data());
    stream.avail_out = static_cast<unsigned>(block.size());
    const int state = inflate(&stream, Z_NO_FLUSH);
    const std::size_t got = block.size() - stream.avail_out;
    if (!out.add(std::string_view(block).substr(0, got), maxBytes)) break;
    out.complete = state == Z_STREAM_END;
    if (state != Z_OK || (got == 0 && stream.avail_in == 0)) break;
  }
  inflateEnd(&stream);
  return out;
}

}  // namespace heft
