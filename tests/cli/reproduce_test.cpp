// `heft reproduce`: tables, numbers and charts, once with the smallest amount of recordings.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

using ReproduceTest = CliTest;

TEST_F(ReproduceTest, WritesTablesNumbersAndCharts) {
  const std::vector<std::string> arguments{"reproduce", "--recordings", "1",      "--format", "markdown", "-o",
                                           "t.md",      "--plots",      "charts", "--json",   "r.json"};
  const Outcome run = heft(arguments);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, IsEmpty());
  const std::string tables = read("t.md");
  EXPECT_THAT(tables, StartsWith("# heft reproduce"));
  for (const char* text : {"| paper: Ceres |", "| 0.0447 |", "| 71 h |", "brute-force", "tilt", "What follows"})
    EXPECT_THAT(tables, HasSubstr(text));
  const auto result = readJson("r.json");
  EXPECT_EQ(result["schema"], "heft.reproduce/1");
  EXPECT_EQ(result["runtimes"].size(), 27u);
  for (const char* file : {"errors-predefined.svg", "errors-guided.svg", "runtimes.svg", "why.svg"})
    EXPECT_THAT(read(std::string("charts/") + file), HasSubstr("</svg>")) << file;
  // What somebody wrote into it would be lost.
  write("t.md", tables + "\nOur remarks\n");
  EXPECT_TRUE(failedWithOneSentence(heft(arguments), "t.md already exists"));
  EXPECT_EQ(read("t.md"), tables + "\nOur remarks\n");
}

TEST_F(ReproduceTest, ReplacesNothingThatItDidNotWrite) {
  write("notes.md", "mine\n");
  EXPECT_TRUE(failedWithOneSentence(heft({"reproduce", "--recordings", "1", "-o", "notes.md"}), "already exists"));
  EXPECT_EQ(read("notes.md"), "mine\n");
  EXPECT_TRUE(failedWithOneSentence(heft({"reproduce", "--recordings", "1", "--plots", "notes.md"}), "notes.md"));
}

}  // namespace
}  // namespace heft::test
