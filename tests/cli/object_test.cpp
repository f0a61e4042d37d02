// `heft estimate WITH --minus WITHOUT`.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using testing::HasSubstr;

class ObjectTest : public CliTest {
 protected:
  void SetUp() override {
    write("both.json", R"({"mass_kg": 1.2, "com_m": [0, 0, 0.08],
                           "inertia_com_kgm2": [[0.005, 0, 0], [0, 0.005, 0], [0, 0, 0.002]]})");
    write("tool.json", R"({"mass_kg": 0.8, "com_m": [0, 0, 0.05],
                           "inertia_com_kgm2": [[0.002, 0, 0], [0, 0.002, 0], [0, 0, 0.001]]})");
    simulate("with", {"--duration", "8", "--rate", "250", "--seed", "5", "--payload", "both.json"});
    simulate("without", {"--duration", "8", "--rate", "250", "--seed", "6", "--payload", "tool.json"});
  }
};

TEST_F(ObjectTest, IsWrittenBesideThePayload) {
  const Outcome run = heft({"estimate", "with.csv", "--minus", "without.csv", "--json", "object.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("The object weighs 0.4"));
  const auto result = readJson("object.json");
  EXPECT_EQ(result["schema"], "heft.estimate/1");
  EXPECT_NEAR(result["payload"]["mass_kg"].get<double>(), 1.2, 0.01);
  const auto& object = result["object"];
  EXPECT_NEAR(object["mass_kg"].get<double>(), 0.4, 0.01);
  EXPECT_NEAR(object["com_m"][2].get<double>(), 0.14, 0.005);
  EXPECT_LT(object["interval95"]["mass_kg"][0].get<double>(), 0.4);
  EXPECT_GT(object["interval95"]["mass_kg"][1].get<double>(), 0.4);
  EXPECT_EQ(object["trust"], result["trust"]);
}

TEST_F(ObjectTest, IsFoundInOneRecordingInWhichItIsPickedUp) {
  simulate("grasp", {"--motion", "free", "--seed", "8", "--rate", "250", "--effect", "payload_change=250"});
  const Outcome run = heft({"estimate", "grasp.csv", "--picked-up", "--json", "grasp.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NEAR(readJson("grasp.json")["object"]["mass_kg"].get<double>(), 0.25, 0.01);
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "with.csv", "--picked-up"}), "picked up or put down"));
  EXPECT_EQ(heft({"estimate", "grasp.csv", "--picked-up", "--minus", "without.csv"}).exitCode, 2);
  EXPECT_EQ(heft({"estimate", "grasp.csv", "--picked-up", "--segments", "all"}).exitCode, 2);
}

TEST_F(ObjectTest, SaysWhatGoesTogether) {
  EXPECT_EQ(heft({"estimate", "with.csv", "--minus", "without.csv", "--method", "ls"}).exitCode, 2);
  EXPECT_EQ(heft({"estimate", "with.csv", "--minus", "without.csv", "--mass", "0.8"}).exitCode, 2);
  EXPECT_EQ(heft({"estimate", "with.csv", "--minus", "without.csv", "--compare"}).exitCode, 2);
  EXPECT_EQ(heft({"estimate", "with.csv", "without.csv", "--minus", "without.csv"}).exitCode, 2);
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "with.csv", "--minus", "missing.csv"}), "missing.csv"));
}

}  // namespace
}  // namespace heft::test
