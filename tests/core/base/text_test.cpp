#include "core/base/text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

namespace heft {
namespace {

TEST(Printable, LeavesPlainTextAlone) {
  EXPECT_EQ(printable("fx [N]"), "fx [N]");
  EXPECT_EQ(printable("Größe µ 力 🙂"), "Größe µ 力 🙂");
  EXPECT_EQ(printable(""), "");
}

TEST(Printable, ReplacesControlCharactersAndBadBytes) {
  EXPECT_EQ(printable(std::string_view("a\0b\n", 4)), "a\uFFFDb\uFFFD");
  EXPECT_EQ(printable("\xFFx"), "\uFFFDx");
  EXPECT_EQ(printable("\xC0\x80"), "\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(printable("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD") << "surrogate";
  EXPECT_EQ(printable("\xE2\x82"), "\uFFFD\uFFFD") << "cut off";
}

TEST(Printable, ShortensWithoutCuttingCharacters) {
  EXPECT_EQ(printable("abcdef", 6), "abcdef");
  EXPECT_EQ(printable("abcdef", 5), "abcde…");
  EXPECT_EQ(printable("ab力", 4), "ab…");
}

TEST(Printable, AnyBytesBecomeTextThatJsonAccepts) {
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes(random() % 40, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() % 256);
    EXPECT_NO_THROW(static_cast<void>(nlohmann::json(printable(bytes)).dump()));
  }
}

TEST(DisplayName, IsThePathItselfForValidNames) {
  const std::filesystem::path path("/tmp/Größe/rec.csv");
  EXPECT_EQ(displayName(path), path.string());
  EXPECT_EQ(displayName(std::filesystem::path("a\xFF.csv")), "a\uFFFD.csv");
  EXPECT_EQ(displayName(std::string(5000, 'x')).size(), 5000u);
}

}  // namespace
}  // namespace heft
