// heft convert: the plain form, which converts to itself.
#include <gmock/gmock.h>

#include <sstream>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using ConvertTest = CliTest;

/// The cells of a CSV's column, as text.
std::vector<std::string> column(const std::string& csv, const std::string& name) {
  std::istringstream lines(csv);
  std::vector<std::string> cells;
  std::size_t wanted = std::string::npos;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::size_t index = 0;
    for (std::string field; std::getline(fields, field, ','); ++index) {
      if (wanted == std::string::npos && field == name) wanted = index;
      if (wanted == index) cells.push_back(field);
    }
  }
  return cells;
}

std::string posesCsv(int rows) {
  std::string text = "time,qx,qy,qz,qw,fx,fy,fz,tx,ty,tz,note\n";
  for (int i = 0; i < rows; ++i) {
    const std::string k = std::to_string(i);
    text +=
        "0." + std::string(3 - k.size(), '0') + k + ",0,0,0,1,1." + k + ",-2.5,3." + k + ",0.1,0.2,-0.3,n" + k + "\n";
  }
  return text;
}

TEST_F(ConvertTest, ConvertsToItself) {
  simulate("rec");
  ASSERT_EQ(heft({"convert", "rec.csv", "once.csv"}).exitCode, 0);
  ASSERT_EQ(heft({"convert", "once.csv", "twice.csv"}).exitCode, 0);
  EXPECT_EQ(read("once.csv"), read("twice.csv"));
  EXPECT_EQ(read("once.meta.json"), read("twice.meta.json"));
  EXPECT_EQ(read("rec.csv"), read("once.csv"));
}

TEST_F(ConvertTest, TurnsTheWrenchIntoOneSign) {
  write("raw.csv", posesCsv(50));
  write("raw.meta.json", R"({"sensor": {"wrench_sign": "payload_on_sensor"}})");
  const Outcome run = heft({"convert", "raw.csv", "rec.csv", "--json", "check.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("sign"));
  EXPECT_EQ(readJson("rec.meta.json")["sensor"]["wrench_sign"], "sensor_on_payload");
  const json check = readJson("check.json");
  EXPECT_EQ(check["schema"], "heft.convert/1");
  EXPECT_EQ(check["wrench_sign_changed"], true);
  EXPECT_EQ(check["samples"], 50);
  const auto before = column(read("raw.csv"), "fy"), after = column(read("rec.csv"), "fy");
  ASSERT_EQ(after.size(), 51u);
  EXPECT_DOUBLE_EQ(std::stod(after[7]), -std::stod(before[7]));
  EXPECT_EQ(column(read("rec.csv"), "note")[5], "n4");  // unknown columns stay
}

TEST_F(ConvertTest, EstimatesTheSameAfterwards) {
  simulate("rec");
  ASSERT_EQ(heft({"convert", "rec.csv", "plain.csv"}).exitCode, 0);
  json before = json::parse(heft({"estimate", "rec.csv", "--json", "-"}).out);
  json after = json::parse(heft({"estimate", "plain.csv", "--json", "-"}).out);
  EXPECT_EQ(before["payload"], after["payload"]);
}

TEST_F(ConvertTest, NeverOverwritesSilently) {
  write("raw.csv", posesCsv(50));
  write("rec.csv", "mine");
  EXPECT_TRUE(failedWithOneSentence(heft({"convert", "raw.csv", "rec.csv"}), "--force"));
  EXPECT_EQ(read("rec.csv"), "mine");
  std::filesystem::remove(path("rec.csv"));
  write("rec.meta.json", "{}");
  EXPECT_TRUE(failedWithOneSentence(heft({"convert", "raw.csv", "rec.csv"}), "rec.meta.json"));
  EXPECT_FALSE(exists("rec.csv"));
  EXPECT_EQ(heft({"convert", "raw.csv", "rec.csv", "--force"}).exitCode, 0);
}

TEST_F(ConvertTest, SaysWhatIsOdd) {
  write("raw.csv", posesCsv(50));
  const Outcome run = heft({"convert", "raw.csv", "rec.csv"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("raw.csv"));  // the column that it does not know, at least
}

}  // namespace
}  // namespace heft::test
