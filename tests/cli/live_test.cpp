// heft live: a replay estimates as the recording itself does.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <random>
#include <sstream>

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

TEST_F(LiveTest, AnotherToolIsNoticedWhileItRuns) {
  // One motion and one sensor, so that the two recordings differ in nothing but the tool.
  const auto tool = [this](const char* name, double mass) {
    write(name, json({{"mass_kg", mass},
                      {"com_m", {0.0, 0.01, 0.06}},
                      {"inertia_com_kgm2", {{0.001, 0, 0}, {0, 0.0011, 0}, {0, 0, 0.0007}}}})
                    .dump());
  };
  tool("heavy.json", 0.9);
  tool("light.json", 0.4);
  simulate("heavy", {"--payload", "heavy.json", "--motion", "free", "--seed", "5"});
  simulate("light", {"--payload", "light.json", "--motion", "free", "--seed", "5"});
  std::istringstream heavy(read("heavy.csv")), light(read("light.csv"));
  std::string both, a, b;
  for (int row = 0; std::getline(heavy, a) && std::getline(light, b); ++row) both += (row <= 10000 ? a : b) + "\n";
  write("both.csv", both);
  write("both.meta.json", read("heavy.meta.json"));
  const Outcome run = heft({"live", "replay:both.csv?speed=5", "--json", "live.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("The tool changed at"));
  EXPECT_THAT(run.err, HasSubstr("0.90 kg became 0.40 kg"));
}

/// Stamps by the time of sending, off by some milliseconds: the line that runs along tells no mass.
TEST_F(LiveTest, WithUnevenStampsTheRunningLineTellsNoNumber) {
  simulate("even", {"--motion", "free", "--seed", "12", "--duration", "8", "--rate", "250"});
  EXPECT_THAT(heft({"live", "replay:even.csv?speed=2", "--json", "even.json"}).err, HasSubstr(" kg ["));
  std::istringstream rows(read("even.csv"));
  std::mt19937 random(5);
  std::normal_distribution<double> jitter(0.0, 3e-3);
  std::string line, uneven;
  std::getline(rows, line);
  uneven = line + "\n";
  for (double last = -1.0; std::getline(rows, line);) {
    const auto comma = line.find(',');
    last = std::max(std::stod(line.substr(0, comma)) + jitter(random), last + 1e-6);
    uneven += fmt::format("{:.7f}{}\n", last, line.substr(comma));
  }
  write("uneven.csv", uneven);
  write("uneven.meta.json", read("even.meta.json"));
  const Outcome run = heft({"live", "replay:uneven.csv?speed=2", "--json", "uneven.json"});
  EXPECT_THAT(run.err, testing::Not(HasSubstr(" kg [")));
  EXPECT_THAT(run.err, HasSubstr("time stamps jitter by"));
}

TEST_F(LiveTest, SourcesThatAreNoneAndSilentOnesSaySo) {
  EXPECT_EQ(heft({"live", "serial:1"}).exitCode, 2);
  EXPECT_TRUE(failedWithOneSentence(heft({"live", "replay:none.csv"}), "none.csv"));
  EXPECT_EQ(heft({"live", "rosbridge:127.0.0.1:1", "--duration", "0.5"}).exitCode, 1);
}

}  // namespace
}  // namespace heft::test
