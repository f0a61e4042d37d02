// Text in blocks, and tables read from them: wherever a block ends, nothing is lost, doubled or numbered wrongly.
#include "core/recording/text_blocks.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>
#include <utility>

#include "core/recording/csv_table.h"
#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;

class Blocks : public testing::Test {
 protected:
  void SetUp() override {
    file_ = std::filesystem::temp_directory_path() / ("heft_blocks_" + std::to_string(::getpid()));
  }
  void TearDown() override { std::filesystem::remove(file_); }
  InputFile written(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    return *InputFile::open(file_);
  }
  std::filesystem::path file_;
};

std::string joined(const TextBlocks& blocks, char newline) {
  std::string out;
  for (std::size_t i = 0; i < blocks.count(); ++i) {
    std::string room;
    const auto block = blocks.block(i, room);
    if (!block) return block.error().message;
    EXPECT_TRUE(block->lines.empty() || block->at == out.size());
    EXPECT_TRUE(out.empty() || block->lines.empty() || out.back() == newline);
    out += block->lines;
  }
  return out;
}

TEST_F(Blocks, HoldEachLineOnce) {
  std::mt19937 random(20261130);
  for (int repeat = 0; repeat < 200; ++repeat) {
    std::string text;
    for (int line = 0; line < 20; ++line)
      text += std::string(random() % 4 == 0 ? random() % 90 : random() % 6, 'x') + "\n";
    if (random() % 2 == 0) text += "end";
    const std::size_t size = 1 + random() % 40;
    EXPECT_EQ(joined(TextBlocks(text, '\n', size), '\n'), text);
    EXPECT_EQ(joined(TextBlocks(written(text), 0, '\n', size), '\n'), text);
  }
}

TEST_F(Blocks, OneLineIsLongerThanAllThatIsReadAtOnce) {
  const std::string text = std::string(100'000, 'x') + "\nshort\n";
  EXPECT_EQ(joined(TextBlocks(written(text), 0, '\n', 1000), '\n'), text);
}

TEST_F(Blocks, BeginBehindAHeader) {
  EXPECT_EQ(TextBlocks(written("header\n"), 7, '\n').count(), 0u);
  std::string room;
  const auto block = TextBlocks(written("header\n1,2\n"), 7, '\n').block(0, room);
  EXPECT_EQ(block->lines, "1,2\n");
  EXPECT_EQ(block->at, 7u);
}

struct Read {
  csv::Rows rows;
  std::vector<double> numbers;
  std::vector<std::string> texts;
  csv::Field first;
};

Result<Read> read(const std::string& text, std::size_t size) {
  const auto header = csv::readHeader(text, "t.csv");
  const auto body = csv::countLines(TextBlocks(header->body, header->newline, size), *header, "t.csv", {});
  if (!body) return body.error();
  Read out;
  out.numbers.assign(static_cast<std::size_t>(body->lines()), 0.0);
  std::vector<csv::Field> fields(2);
  fields[0].numbers = out.numbers.data();
  fields[1].text = &out.texts;
  auto rows = csv::readRows(*header, *body, fields, "t.csv", {});
  if (!rows) return rows.error();
  out.rows = std::move(*rows);
  out.numbers.resize(out.rows.lines.size());
  out.first = fields[0];
  return out;
}

TEST(TableInBlocks, ReadsTheSameWhereverTheyEnd) {
  std::string text = "a,b\n";
  for (int i = 0; i < 60; ++i) {
    if (i % 7 == 3) text += i % 2 == 0 ? "\n" : " \r\n";
    text += (i % 11 == 5 ? std::string("nan") : std::to_string(i)) + ",t" + std::to_string(i * i) + "\n";
  }
  for (const std::string& end : {std::string(), std::string("\n\n"), std::string("17"), std::string("17,last")}) {
    const auto whole = read(text + end, 1u << 20);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->rows.cutLine > 0, end == "17");
    EXPECT_EQ(whole->rows.firstBlankLine, 5);
    EXPECT_EQ(whole->first.missing, 5);
    for (std::size_t size = 1; size < 80; ++size) {
      const auto pieces = read(text + end, size);
      ASSERT_TRUE(pieces);
      EXPECT_EQ(pieces->rows.lines, whole->rows.lines);
      EXPECT_EQ(pieces->rows.cutLine, whole->rows.cutLine);
      EXPECT_EQ(pieces->rows.firstBlankLine, whole->rows.firstBlankLine);
      EXPECT_EQ(pieces->texts, whole->texts);
      EXPECT_EQ(pieces->first.missing, whole->first.missing);
      EXPECT_EQ(pieces->first.firstMissingLine, whole->first.firstMissingLine);
      ASSERT_EQ(pieces->numbers.size(), whole->numbers.size());
      for (std::size_t i = 0; i < whole->numbers.size(); ++i)
        EXPECT_TRUE(pieces->numbers[i] == whole->numbers[i] ||
                    (std::isnan(pieces->numbers[i]) && std::isnan(whole->numbers[i])));
    }
  }
}

TEST(TableInBlocks, BlankLinesAtTheEndAreNone) {
  for (const std::size_t size : {3u, 1000u}) EXPECT_EQ(read("a,b\n1,x\n2,y\n\n\n", size)->rows.firstBlankLine, 0);
}

TEST(TableInBlocks, TheFirstOfSeveralMistakesIsNamed) {
  std::string text = "a,b\n";
  for (int i = 0; i < 50; ++i) text += i == 20 || i == 31 || i == 45 ? "1;2,x\n" : "1,x\n";
  for (const std::size_t size : {5u, 64u, 1u << 20}) {
    const auto result = read(text, size);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, HasSubstr("t.csv:22:1"));
  }
}

TEST_F(Blocks, AFileThatGotShorterMeanwhileIsNotReadShort) {
  std::string text = "a,b\n";
  for (int i = 0; i < 100; ++i) text += "1,2\n";
  const InputFile file = written(text);
  const auto header = csv::readHeader(text, "t.csv");
  const auto body = csv::countLines(TextBlocks(file, 4, '\n', 50), *header, "t.csv", {});
  ASSERT_TRUE(body);
  std::filesystem::resize_file(file_, 200);
  std::vector<csv::Field> fields(2);
  const auto rows = csv::readRows(*header, *body, fields, "t.csv", {});
  ASSERT_FALSE(rows);
  EXPECT_THAT(rows.error().message, HasSubstr("changed while it was read"));
}

TEST_F(Blocks, APipeIsOpenedOnce) {
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  // The writer is gone before the reader has read: who opens the pipe once more waits forever.
  std::thread writer([&] { std::ofstream(file_) << goodTable(Form::orientation, 30).text(); });
  const auto result = readRecording(file_);
  writer.join();
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->recording.rows(), 30);
}

TEST(TableInBlocks, AZeroByteIsFoundInItsLine) {
  for (const auto& [text, line] : {std::pair(std::string("1,2\n1,2\n"), 4), {std::string("1,2\n1,"), 3}}) {
    const csv::Header header{',', '\n', 1, {"a", "b"}, {}};
    const std::string body = text + std::string(1, '\0') + "2\n";
    for (const std::size_t size : {1u, 5u, 1000u}) {
      const auto counted = csv::countLines(TextBlocks(body, '\n', size), header, "t.csv", {});
      ASSERT_FALSE(counted);
      EXPECT_THAT(counted.error().message, HasSubstr("t.csv:" + std::to_string(line) + ":"));
    }
  }
}

TEST_F(Blocks, AZeroByteFarBehindIsFound) {
  std::string text = "time,qx,qy,qz,qw,fx,fy,fz,tx,ty,tz\n";
  const std::string row = "0,0,0,0,1,0,0,0,0,0,0\n";
  while (text.size() < (std::size_t{6} << 20)) text += row;
  const auto at = text.size() - row.size() / 2;
  const auto lines = std::count(text.begin(), text.end(), '\n');
  text[at] = '\0';
  written(text);
  const auto result = readRecording(file_);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, AllOf(HasSubstr(":" + std::to_string(lines) + ":"),
                                            HasSubstr("byte " + std::to_string(at + 1) + " is zero")));
}

}  // namespace
}  // namespace heft
