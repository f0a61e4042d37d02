// `heft passport RESULT --tool NAME`.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class PassportCommandTest : public CliTest {
 protected:
  void estimated(const std::string& name, const char* mass, const char* seed) {
    write("tool.json", std::string(R"({"mass_kg": )") + mass + R"(, "com_m": [0, 0, 0.05],
                           "inertia_com_kgm2": [[0.002, 0, 0], [0, 0.002, 0], [0, 0, 0.001]]})");
    simulate(name, {"--duration", "10", "--rate", "250", "--seed", seed, "--payload", "tool.json"});
    ASSERT_EQ(heft({"estimate", name + ".csv", "--json", name + ".json"}).exitCode, 0);
  }
  void SetUp() override { estimated("monday", "0.8", "31"); }
  Outcome passport(std::vector<std::string> more) {
    std::vector<std::string> words{"passport", "monday.json", "--tool", "Gripper 3"};
    words.insert(words.end(), more.begin(), more.end());
    return heft(words);
  }
};

TEST_F(PassportCommandTest, HoldsNumbersProofAndCausesOnOnePage) {
  simulate("check", {"--duration", "10", "--rate", "250", "--seed", "32", "--payload", "tool.json"});
  ASSERT_EQ(heft({"prove", "monday.json", "check.csv", "--json", "proof.json"}).exitCode, 0);
  ASSERT_EQ(heft({"diagnose", "monday.csv", "--surrogates", "0", "--json", "found.json"}).exitCode, 0);
  const Outcome run = passport({"--proof", "proof.json", "--causes", "found.json", "--date", "2026-11-28", "--json",
                                "first.json", "--page", "first.html"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("PASS"));
  const auto made = readJson("first.json");
  EXPECT_EQ(made["schema"], "heft.passport/1");
  EXPECT_EQ(made["date"], "2026-11-28");
  EXPECT_EQ(made["proof"]["verdict"], "pass");
  EXPECT_TRUE(made["looked_for_causes"].get<bool>());
  EXPECT_FALSE(made["not_seen"].empty());
  const std::string page = read("first.html");
  for (const char* text : {"Gripper 3", "PASS", "Not detectable in this recording: ", "None were found.", "kg cm²"})
    EXPECT_THAT(page, HasSubstr(text));

  // The next one says what changed.
  estimated("monday", "0.9", "33");
  const Outcome next = passport({"--since", "first.json", "--json", "second.json"});
  ASSERT_EQ(next.exitCode, 0) << next.err;
  EXPECT_THAT(next.out, HasSubstr("Since the passport of 2026-11-28: The tool has changed: the difference exceeds the "
                                  "measurement uncertainty."));
  EXPECT_TRUE(readJson("second.json")["since"]["mass_and_centre_changed"].get<bool>());
  // A proof of the numbers before is none of these.
  EXPECT_TRUE(failedWithOneSentence(passport({"--proof", "proof.json"}), "other numbers"));
}

TEST_F(PassportCommandTest, CausesThatWereTakenOutAreSaidToBe) {
  simulate("monday", {"--duration", "10", "--rate", "250", "--seed", "34", "--payload", "tool.json", "--effect",
                      "time_offset=20"});
  ASSERT_EQ(heft({"diagnose", "monday.csv", "--surrogates", "0", "--json", "found.json", "--result", "monday.json",
                  "--force"})
                .exitCode,
            0);
  ASSERT_FALSE(readJson("found.json")["causes"].empty());
  EXPECT_THAT(passport({"--causes", "found.json"}).out, HasSubstr("The numbers are corrected for it."));
  ASSERT_EQ(heft({"estimate", "monday.csv", "--json", "monday.json"}).exitCode, 0);
  EXPECT_THAT(passport({"--causes", "found.json"}).out, HasSubstr("The numbers are not corrected for it."));
}

TEST_F(PassportCommandTest, ToldFromBadInput) {
  EXPECT_EQ(heft({"passport", "monday.json"}).exitCode, 2);
  EXPECT_EQ(passport({"--date", "yesterday"}).exitCode, 2);
  write("empty.json", "{}");
  for (const char* option : {"--proof", "--causes", "--since"})
    EXPECT_TRUE(failedWithOneSentence(passport({option, "empty.json"}), "empty.json")) << option;
  EXPECT_TRUE(failedWithOneSentence(heft({"passport", "empty.json", "--tool", "A"}), "empty.json"));
  EXPECT_TRUE(failedWithOneSentence(heft({"passport", "missing.json", "--tool", "A"}), "missing.json"));
  ASSERT_EQ(passport({"--json", "made.json"}).exitCode, 0);
  EXPECT_TRUE(failedWithOneSentence(passport({"--json", "made.json"}), "made.json")) << "nothing is replaced unasked";
  EXPECT_TRUE(failedWithOneSentence(heft({"passport", "monday.json", "--tool", "Camera", "--since", "made.json"}),
                                    "another tool"));
  EXPECT_EQ(passport({"--json", "made.json", "--force"}).exitCode, 0);
}

}  // namespace
}  // namespace heft::test
