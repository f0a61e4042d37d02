#include "core/import/zip_file.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <stop_token>
#include <string>

#include "core/import/bytes.h"
#include "core/import/compression.h"
#include "core/import/streams.h"
#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

std::string bytes16(std::size_t value) { return {static_cast<char>(value & 255U), static_cast<char>(value >> 8U)}; }

/// A directory with one entry, which has this extra field, and the end that points at it.
std::string directoryWith(const std::string& extra) {
  const std::string nothing(4, '\0');
  const std::string entry = std::string("PK\1\2", 4) + std::string(16, '\0') + nothing + nothing + bytes16(1) +
                            bytes16(static_cast<unsigned>(extra.size())) + bytes16(0) + std::string(8, '\0') + nothing +
                            "a" + extra;
  return entry + std::string("PK\5\6", 4) + std::string(12, '\0') + nothing + bytes16(0);
}

TEST(ZipFile, AnExtraFieldLongerThanItsPlaceEnds) {
  EXPECT_EQ(zipMembers(directoryWith(bytes16(7) + bytes16(2) + "xy")).size(), 1U);
  // Says 100 bytes and has 4
  EXPECT_EQ(zipMembers(directoryWith(bytes16(7) + bytes16(100) + "wxyz")).size(), 1U);
}

std::string deflated(const std::string& text) {
  std::string out(compressBound(text.size()), '\0');
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
  stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<unsigned>(text.size());
  stream.next_out = reinterpret_cast<unsigned char*>(out.data());
  stream.avail_out = static_cast<unsigned>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

std::string bytes32(std::size_t value) { return bytes16(value & 0xFFFFU) + bytes16((value >> 16U) & 0xFFFFU); }

/// An archive whose directory names the same deflated member so many times.
std::string archiveOf(const std::string& text, int times) {
  const std::string packed = deflated(text);
  std::string out = std::string("PK\3\4", 4) + std::string(22, '\0') + bytes16(0) + bytes16(0) + packed;
  const std::size_t directory = out.size();
  for (int k = 0; k < times; ++k)
    out += std::string("PK\1\2", 4) + std::string(6, '\0') + bytes16(8) + std::string(8, '\0') +
           bytes32(packed.size()) + bytes32(text.size()) + bytes16(5) + bytes16(0) + bytes16(0) + std::string(8, '\0') +
           bytes32(0) + "a.npy";
  return out + std::string("PK\5\6", 4) + std::string(12, '\0') + bytes32(directory) + bytes16(0);
}

TEST(ZipFile, AMemberIsReadUpToTheLimitAndUntilItIsStopped) {
  const std::string text(3u << 20, 'x');
  const std::string archive = archiveOf(text, 1);
  const auto members = zipMembers(archive);
  ASSERT_EQ(members.size(), 1U);
  const Unpacked whole = readZipMember(archive, members[0], text.size(), {});
  EXPECT_TRUE(whole.complete && whole.bytes == text);
  const Unpacked part = readZipMember(archive, members[0], 1000, {});
  EXPECT_TRUE(!part.complete && part.bytes.size() == 1000U);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(readZipMember(archive, members[0], text.size(), {stop.get_token(), {}}).bytes.empty());
}

using ZipFiles = testing_support::InFolder;

TEST_F(ZipFiles, NumpyFilesThatUnpackToTooMuchAreCutAndThatIsTold) {
  // Texts, which are not kept: 100 times 12 MB are more than 1 GB and 64 times the file.
  const std::string head = "{'descr': '|S8', 'fortran_order': False, 'shape': (1500000,), }\n";
  const std::string array = "\x93NUMPY\1" + std::string(1, '\0') + bytes16(head.size()) + head;
  for (const int times : {3, 100}) {
    const auto path = write("texts.npz", archiveOf(array + std::string(12000000, '\0'), times));
    const auto set = readNumpyStreams(path, {}, {}, {});
    ASSERT_TRUE(set.ok());
    const bool told = std::ranges::any_of(set->findings, [](const auto& f) { return f.code == "file_too_large"; });
    EXPECT_EQ(told, times == 100);
  }
}

TEST(Compression, WhatIsTooLargeFillsTheLimitSoThatTheBudgetIsSpent) {
  const std::string text(3u << 20, 'x');
  std::string zstd(ZSTD_compressBound(text.size()), '\0');
  zstd.resize(ZSTD_compress(zstd.data(), zstd.size(), text.data(), text.size(), 1));
  for (const std::size_t most : {text.size() - 1, text.size()}) {
    const Unpacked out = unpack(zstd, Compression::zstd, most, {});
    EXPECT_EQ(out.bytes.size(), most);
    EXPECT_EQ(out.complete, most == text.size());
  }
}

TEST(ByteReader, NothingRemainsAfterAReadPastTheEnd) {
  ByteReader reader("abcdef");
  EXPECT_EQ(reader.take(2), "ab");
  EXPECT_EQ(reader.remaining(), 4U);
  EXPECT_TRUE(reader.take(5).empty());
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.remaining(), 0U);
  EXPECT_TRUE(reader.atEnd());
  EXPECT_TRUE(reader.take(1).empty());
}

}  // namespace
}  // namespace heft
