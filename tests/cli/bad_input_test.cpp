// Bad files: exit code 1 and one clear sentence that names the file, for every command that reads one.
#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using testing::HasSubstr;

using BadInputTest = CliTest;

TEST_F(BadInputTest, MissingFolderEmptyAndBinaryRecordings) {
  std::filesystem::create_directory(path("folder.csv"));
  write("empty.csv", "");
  write("binary.csv", std::string("\x7f"
                                  "ELF\0\1\2\3\xff\xfe\n\0\0",
                                  13));
  write("header.csv", "time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz\n");
  for (const std::string name : {"none.csv", "folder.csv", "empty.csv", "binary.csv", "header.csv"}) {
    EXPECT_TRUE(failedWithOneSentence(heft({"estimate", name}), name));
    EXPECT_TRUE(failedWithOneSentence(heft({"convert", name, "out.csv"}), name));
    EXPECT_FALSE(exists("out.csv")) << name;
  }
}

TEST_F(BadInputTest, TextInANumberIsNamedByLineAndColumn) {
  simulate("rec");
  std::string text = read("rec.csv");
  std::size_t line = 0;
  for (int i = 0; i < 41; ++i) line = text.find('\n', line) + 1;  // start of line 42
  const std::size_t second = text.find(',', line) + 1;
  text.replace(second, text.find(',', second) - second, "oops");
  write("rec.csv", text);
  const Outcome run = heft({"estimate", "rec.csv"});
  const std::string place = "rec.csv:42:2";
  if (run.exitCode == 0)
    EXPECT_THAT(run.out + run.err, HasSubstr(place));  // a row may be left out, but not in silence
  else
    EXPECT_TRUE(failedWithOneSentence(run, place));
}

TEST_F(BadInputTest, NeitherMotionFormNamesBoth) {
  write("rec.csv", "time,fx,fy,fz,tx,ty,tz\n0,0,0,0,0,0,0\n0.01,0,0,0,0,0,0\n");
  const Outcome run = heft({"estimate", "rec.csv"});
  EXPECT_TRUE(failedWithOneSentence(run, "q1"));
  EXPECT_THAT(run.err, HasSubstr("qw"));
}

TEST_F(BadInputTest, SideFiles) {
  simulate("rec");
  write("broken.json", "{\"robot\": \n  panda}");
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "rec.csv", "--meta", "none.json"}), "none.json"));
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "rec.csv", "--meta", "broken.json"}), "broken.json:2:"));
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "rec.csv", "--known", "none.json"}), "none.json"));
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "rec.csv", "--known", "broken.json"}), "broken.json:2:"));
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "rec.csv", "--shape-file", "broken.json"}), "broken.json:2:"));
  write("nothing.json", "{}");
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "rec.csv", "--known", "nothing.json"}), "mass_kg"));
  const std::vector<std::string> simulateWith{"simulate", "--motion", "free", "-o", "new.csv", "--payload"};
  for (const std::string file : {"none.json", "broken.json", "nothing.json"}) {
    auto arguments = simulateWith;
    arguments.push_back(file);
    EXPECT_TRUE(failedWithOneSentence(heft(arguments), file));
  }
  write("impossible.json", R"({"mass_kg": 1, "com_m": [0,0,0], "inertia_com_kgm2": [[1,0,0],[0,0.1,0],[0,0,0.1]]})");
  auto arguments = simulateWith;
  arguments.push_back("impossible.json");
  EXPECT_TRUE(failedWithOneSentence(heft(arguments), "cannot exist"));
  EXPECT_FALSE(exists("new.csv"));
}

TEST_F(BadInputTest, PlacesThatCannotBeWritten) {
  simulate("rec");
  EXPECT_TRUE(failedWithOneSentence(heft({"simulate", "--motion", "free", "--duration", "2", "-o", "no/such/r.csv"}),
                                    "no/such"));
  EXPECT_TRUE(failedWithOneSentence(heft({"convert", "rec.csv", "no/such/r.csv"}), "no/such"));
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "rec.csv", "--json", "no/such/r.json"}), "no/such"));
  if (std::filesystem::exists("/dev/full")) {
    const Outcome run = heft({"estimate", "rec.csv", "--json", "/dev/full"});
    EXPECT_TRUE(failedWithOneSentence(run, "/dev/full"));
  }
}

TEST_F(BadInputTest, NamesThatAreNotUtf8) {
  simulate("rec");
  std::filesystem::rename(path("rec.csv"), path("r\xff\xfe.csv"));
  std::filesystem::rename(path("rec.meta.json"), path("r\xff\xfe.meta.json"));
  const Outcome run = heft({"estimate", "r\xff\xfe.csv", "--json", "-"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_TRUE(nlohmann::json::accept(run.out));
  EXPECT_EQ(heft({"convert", "r\xff\xfe.csv", "\xfe.csv", "--json", "check.json"}).exitCode, 0);
  EXPECT_TRUE(nlohmann::json::accept(read("check.json")));
}

TEST_F(BadInputTest, NullDeviceTakesEverything) {
  simulate("rec");
  EXPECT_EQ(heft({"estimate", "rec.csv", "--json", "/dev/null"}).exitCode, 0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace heft::test
