#include "core/import/zip_file.h"

#include <gtest/gtest.h>

#include <string>

#include "core/import/bytes.h"

namespace heft {
namespace {

std::string bytes16(unsigned value) { return {static_cast<char>(value & 255U), static_cast<char>(value >> 8U)}; }

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
