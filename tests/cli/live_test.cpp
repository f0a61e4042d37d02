// heft live: a replay estimates as the recording itself does.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using LiveTest = CliTest;

TEST_F(LiveTest, AReplayEstimatesAndRecordsTheSame) {
  simulate("rec");
  const Outcome run = heft({"live", "replay:rec.csv?speed=6", "--record", "live.csv", "--json", "live.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  ASSERT_EQ(heft({"estimate", "rec.csv", "--json", "batch.json"}).exitCode, 0);
  ASSERT_EQ(heft({"estimate", "live.csv", "--json", "recorded.json"}).exitCode, 0);
  const json live = readJson("live.json");
  EXPECT_EQ(live["schema"], "heft.estimate/1");
  EXPECT_EQ(live["live"]["samples"], live["recording"]["samples"]);
  const double mass = readJson("batch.json")["payload"]["mass_kg"];
  EXPECT_NEAR(live["payload"]["mass_kg"].get<double>(), mass, 1e-3 * mass);
  EXPECT_NEAR(readJson("recorded.json")["payload"]["mass_kg"].get<double>(), mass, 1e-3 * mass);
  // A second run does not touch what the first one recorded.
  EXPECT_TRUE(failedWithOneSentence(heft({"live", "replay:rec.csv?speed=6", "--record", "live.csv"}), "exists"));
}

TEST_F(LiveTest, SourcesThatAreNoneAndSilentOnesSaySo) {
  EXPECT_EQ(heft({"live", "serial:1"}).exitCode, 2);
  EXPECT_TRUE(failedWithOneSentence(heft({"live", "replay:none.csv"}), "none.csv"));
  EXPECT_EQ(heft({"live", "rosbridge:127.0.0.1:1", "--duration", "0.5"}).exitCode, 1);
}

}  // namespace
}  // namespace heft::test
