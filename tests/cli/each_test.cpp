// `heft estimate --each`: many recordings, each by itself, one line of JSON a recording.
#include <gmock/gmock.h>

#include <map>
#include <sstream>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class EachTest : public CliTest {
 protected:
  void SetUp() override {
    simulate("a", {"--duration", "6", "--rate", "250", "--seed", "1"});
    simulate("b", {"--duration", "6", "--rate", "250", "--seed", "2"});
    simulate("c", {"--duration", "6", "--rate", "250", "--seed", "3"});
    write("broken.csv", "time,force\n1,2\n");
  }
  Outcome each(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"estimate",   "--each", "a.csv",        "b.csv",
                                       "broken.csv", "c.csv",  "--json-lines", "out.jsonl"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return heft(arguments);
  }
  std::map<std::string, json> lines() const {
    std::map<std::string, json> out;
    std::istringstream text(read("out.jsonl"));
    for (std::string line; std::getline(text, line);) {
      const json entry = json::parse(line);
      EXPECT_TRUE(out.emplace(entry["file"], entry).second) << "twice: " << line;
    }
    return out;
  }
};

TEST_F(EachTest, EveryRecordingHasALineAsTheCommandForIt) {
  for (const char* jobs : {"1", "3"}) {
    const Outcome run = each({"--jobs", jobs, "--force"});
    EXPECT_TRUE(failedWithOneSentence(run, "1 of 4 recordings could not be estimated")) << run.err;
    const auto got = lines();
    ASSERT_EQ(got.size(), 4u);
    for (const char* name : {"a.csv", "b.csv", "c.csv"}) {
      EXPECT_EQ(got.at(name)["schema"], "heft.estimate/1");
      json alone = json::parse(heft({"estimate", name, "--json", "-"}).out);
      json line = got.at(name);
      line.erase("file");
      for (json* each : {&alone, &line}) each->erase("timing_s");
      EXPECT_EQ(line, alone) << name;
    }
    EXPECT_THAT(got.at("broken.csv")["error"].get<std::string>(), HasSubstr("broken.csv"));
  }
}

TEST_F(EachTest, GoesOnWhereItStopped) {
  ASSERT_EQ(each({}).exitCode, 1);
  const std::string whole = read("out.jsonl");
  // As if it had been stopped while the last line was being written.
  write("out.jsonl", whole.substr(0, whole.size() - 100));
  const Outcome again = each({});
  EXPECT_THAT(again.err, HasSubstr("3 of 4 recordings already have a line."));
  EXPECT_EQ(lines().size(), 4u);
  const std::string done = read("out.jsonl");
  const Outcome nothingLeft = each({});
  EXPECT_EQ(nothingLeft.exitCode, 1) << "one is still without a result";
  EXPECT_THAT(nothingLeft.err, HasSubstr("1 of 4 recordings could not be estimated"));
  EXPECT_EQ(read("out.jsonl"), done);
}

TEST_F(EachTest, NeverWritesIntoAnotherFile) {
  write("out.jsonl", "my notes\n");
  EXPECT_TRUE(failedWithOneSentence(each({}), "out.jsonl, line 1"));
  EXPECT_EQ(read("out.jsonl"), "my notes\n");
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "--each", "a.csv", "--json-lines", "no/such/folder.jsonl"}),
                                    "folder.jsonl"));
}

TEST_F(EachTest, SaysWhatGoesTogether) {
  EXPECT_EQ(heft({"estimate", "--each", "a.csv"}).exitCode, 2);
  EXPECT_EQ(heft({"estimate", "a.csv", "--jobs", "2"}).exitCode, 2);
  EXPECT_EQ(each({"--jobs", "-1"}).exitCode, 2);
  EXPECT_EQ(each({"--json", "x.json"}).exitCode, 2);
  const Outcome toScreen = heft({"estimate", "--each", "a.csv", "--json-lines", "-"});
  EXPECT_EQ(json::parse(toScreen.out)["file"], "a.csv");
}

}  // namespace
}  // namespace heft::test
