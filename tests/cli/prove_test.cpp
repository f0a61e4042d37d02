// `heft prove PAYLOAD RECORDING`.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ProveTest : public CliTest {
 protected:
  void SetUp() override {
    write("tool.json", R"({"mass_kg": 0.8, "com_m": [0, 0, 0.05],
                           "inertia_com_kgm2": [[0.002, 0, 0], [0, 0.002, 0], [0, 0, 0.001]]})");
    simulate("check", {"--duration", "10", "--rate", "250", "--seed", "21", "--payload", "tool.json"});
  }
};

TEST_F(ProveTest, PassesTheRightPayloadAndItsEstimate) {
  const Outcome bare = heft({"prove", "tool.json", "check.csv", "--json", "proof.json"});
  ASSERT_EQ(bare.exitCode, 0) << bare.out << bare.err;
  EXPECT_THAT(bare.out, HasSubstr("PASS"));
  const auto proof = readJson("proof.json");
  EXPECT_EQ(proof["schema"], "heft.prove/1");
  EXPECT_TRUE(proof["passed"].get<bool>());
  EXPECT_LT(proof["would_see"]["mass_kg"].get<double>(), 0.04);

  simulate("first", {"--duration", "10", "--rate", "250", "--seed", "22", "--payload", "tool.json"});
  ASSERT_EQ(heft({"estimate", "first.csv", "--json", "first.json"}).exitCode, 0);
  EXPECT_EQ(heft({"prove", "first.json", "check.csv"}).exitCode, 0);
}

TEST_F(ProveTest, SaysWhyNot) {
  write("heavy.json", R"({"mass_kg": 0.84, "com_m": [0, 0, 0.05],
                          "inertia_com_kgm2": [[0.002, 0, 0], [0, 0.002, 0], [0, 0, 0.001]]})");
  const Outcome run = heft({"prove", "heavy.json", "check.csv", "--json", "proof.json"});
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_THAT(run.err, StartsWith("heft: NOT YET: The entered mass of 0.840 kg is off by +0.04"));
  EXPECT_THAT(run.out, HasSubstr("NOT YET."));
  EXPECT_EQ(readJson("proof.json")["verdict"], "not_yet");
  EXPECT_EQ(readJson("proof.json")["reasons"][0]["code"], "other_mass");
}

TEST_F(ProveTest, ToldFromBadInput) {
  EXPECT_EQ(heft({"prove", "tool.json"}).exitCode, 2);
  EXPECT_EQ(heft({"prove", "tool.json", "check.csv", "--segments", "some"}).exitCode, 2);
  write("empty.json", "{}");
  EXPECT_TRUE(failedWithOneSentence(heft({"prove", "empty.json", "check.csv"}), "empty.json"));
  EXPECT_TRUE(failedWithOneSentence(heft({"prove", "tool.json", "missing.csv"}), "missing.csv"));
}

}  // namespace
}  // namespace heft::test
