// Recordings of other programs through the command line.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using ImportTest = CliTest;

std::string fixture(const std::string& name) { return HEFT_SOURCE_DIR "/tests/data/recordings/" + name; }

TEST_F(ImportTest, ConvertBringsEveryKindToThePlainForm) {
  std::string first;
  for (const char* const name : {"ros1_lz4.bag", "plain.mcap", "ros2_bag"}) {
    const Outcome run = heft({"convert", fixture(name), "rec.csv", "--force", "--json", "check.json"});
    ASSERT_EQ(run.exitCode, 0) << name << run.err;
    EXPECT_EQ(readJson("check.json")["samples"], 100);
    const auto header = read("rec.csv").substr(0, 24);
    EXPECT_EQ(header.rfind("time,q1,q2,q3,q4,q5,q6,q", 0), 0u) << header;
  }
}

TEST_F(ImportTest, ListShowsTheGuessAndWritesNothing) {
  const Outcome run = heft({"convert", fixture("zstd.mcap"), "--list", "--json", "list.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("wrench.force.x  -> fx"));
  const json list = readJson("list.json");
  EXPECT_EQ(list["schema"], "heft.contents/1");
  EXPECT_EQ(list["streams"].size(), 2u);
  EXPECT_EQ(heft({"convert", fixture("zstd.mcap")}).exitCode, 2);
}

TEST_F(ImportTest, ListShowsTheColumnsWhereNoneIsTheTime) {
  write("own.csv", "a,b,c,fx,fy,fz,tx,ty,tz\n1,2,3,4,5,6,7,8,9\n2,3,4,5,6,7,8,9,1\n3,3,4,5,6,7,8,9,1\n");
  const Outcome run = heft({"convert", "own.csv", "--list"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("3 samples, no clock\n    a\n    b\n    c\n    fx"));
  EXPECT_THAT(run.out, HasSubstr("--use time="));
}

TEST_F(ImportTest, WishesAreObeyedOrRefused) {
  EXPECT_EQ(heft({"convert", fixture("log.h5"), "a.csv", "--use", "fx=/sensor:ft[2]"}).exitCode, 0);
  EXPECT_TRUE(failedWithOneSentence(heft({"convert", fixture("log.h5"), "b.csv", "--use", "fx=/nowhere"}), "/nowhere"));
  EXPECT_TRUE(failedWithOneSentence(heft({"convert", fixture("log.h5"), "b.csv", "--map", "none.json"}), "none.json"));
  write("half.bag", "#ROSBAG V2.0\n");
  EXPECT_TRUE(failedWithOneSentence(heft({"convert", "half.bag", "b.csv"}), "half.bag"));
}

}  // namespace
}  // namespace heft::test
