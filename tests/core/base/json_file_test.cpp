#include "core/base/json_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace heft {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class JsonFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("heft_base_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::filesystem::path folder_;
};

TEST_F(JsonFile, ParsesValidText) {
  const auto result = parseJson(R"({"mass_kg": 0.5})", "x.json");
  ASSERT_TRUE(result);
  EXPECT_EQ((*result)["mass_kg"], 0.5);
}

TEST_F(JsonFile, ErrorNamesLineAndColumn) {
  const auto result = parseJson("{\n  \"a\": 1,\n  \"b\": oops\n}", "x.json");
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, StartsWith("x.json:3:"));
  EXPECT_THAT(result.error().message, HasSubstr("not valid JSON"));
  EXPECT_THAT(result.error().message, HasSubstr("invalid literal"));
}

TEST_F(JsonFile, EveryKindOfRubbishIsAnError) {
  for (const std::string text : {"", "{", "[1,2", "{\"a\":}", "nan", "{\"a\": NaN}", "{'a': 1}", "1e999",
                                 "// no comments\n{}", "\"\xFF\"", "{} {}", "\xEF\xBB"})
    EXPECT_FALSE(parseJson(text, "x.json")) << text;
}

TEST_F(JsonFile, DeepNestingIsRefusedNotFatal) {
  const std::string deep = std::string(1000000, '[') + std::string(1000000, ']');
  const auto result = parseJson(deep, "x.json");
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("nested"));
  EXPECT_TRUE(parseJson("[\"" + std::string(1000, '[') + "\"]", "x.json")) << "brackets in a text are no nesting";
}

TEST_F(JsonFile, ReadsWhatWasWritten) {
  const std::string text("line\r\n\0\xFF end", 12);
  ASSERT_TRUE(writeTextFile(folder_ / "a.txt", text));
  const auto read = readTextFile(folder_ / "a.txt");
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, text);
}

TEST_F(JsonFile, ReadsLargeAndEmptyFiles) {
  const std::string large(300000, 'x');
  EXPECT_EQ(*readTextFile(write("large.txt", large)), large);
  EXPECT_EQ(*readTextFile(write("empty.txt", "")), "");
}

TEST_F(JsonFile, LimitHoldsForFilesAndDevices) {
  const auto file = write("ten.txt", "0123456789");
  EXPECT_TRUE(readTextFile(file, 10));
  const auto result = readTextFile(file, 9);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("ten.txt"));
  EXPECT_FALSE(readTextFile("/dev/zero", 100000));
}

TEST_F(JsonFile, MissingFilesAndFoldersAreNamed) {
  EXPECT_THAT(readJsonFile(folder_ / "no.json").error().message, HasSubstr("no.json: there is no such file"));
  EXPECT_THAT(readJsonFile(folder_).error().message, HasSubstr("is a folder"));
  EXPECT_THAT(writeTextFile(folder_, "x").error().message, HasSubstr("is a folder"));
  EXPECT_FALSE(writeTextFile(folder_ / "no" / "such" / "file.txt", "x"));
}

TEST_F(JsonFile, ReadFailureIsAnErrorNotAnEmptyText) {
  // Readable by permission, but its first page is never mapped.
  if (!std::filesystem::exists("/proc/self/mem")) GTEST_SKIP() << "This system has no /proc/self/mem.";
  EXPECT_FALSE(readTextFile("/proc/self/mem"));
}

TEST_F(JsonFile, UnreadableFileIsAnError) {
  const auto file = write("secret.txt", "x");
  std::filesystem::permissions(file, std::filesystem::perms::none);
  if (::geteuid() == 0) GTEST_SKIP() << "Root may read every file.";
  EXPECT_THAT(readTextFile(file).error().message, HasSubstr("cannot be opened"));
}

TEST_F(JsonFile, ReadsPipesToTheirEnd) {
  const auto pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::ofstream(pipe) << std::string(100000, 'y');
    ::_exit(0);
  }
  const auto text = readTextFile(pipe);
  ::waitpid(child, nullptr, 0);
  ASSERT_TRUE(text);
  EXPECT_EQ(text->size(), 100000u);
}

TEST_F(JsonFile, WritingLeavesNoTemporaryFileAndReplaces) {
  const auto file = write("out.json", "old");
  ASSERT_TRUE(writeTextFile(file, "new"));
  EXPECT_EQ(*readTextFile(file), "new");
  const auto count = std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator());
  EXPECT_EQ(count, 1);
}

TEST_F(JsonFile, WritesToDevices) { EXPECT_TRUE(writeTextFile("/dev/null", "x")); }

}  // namespace
}  // namespace heft
