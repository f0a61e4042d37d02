// `heft estimate --compare`: every method in one table, and in the result beside the chosen one.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> kMethods{"map",       "ls",    "wls",      "tls",        "tls-fast",
                                        "tls-exact", "ceres", "eigen-lm", "brute-force"};

using CompareTest = CliTest;

TEST_F(CompareTest, OneTableHasALineForEveryMethod) {
  simulate("rec");
  const Outcome run = heft({"estimate", "rec.csv", "--compare", "--known", "rec.truth.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  for (const auto& method : kMethods) EXPECT_THAT(run.out, HasSubstr("\n" + method + " ")) << method;
  EXPECT_THAT(run.out, HasSubstr("err. %"));
  EXPECT_THAT(heft({"estimate", "rec.csv", "--compare"}).out, Not(HasSubstr("err. %")));
}

TEST_F(CompareTest, JsonIsTheChosenMethodsResultWithASummaryOfEach) {
  simulate("rec");
  const std::vector<std::string> chosen{"estimate", "rec.csv", "--method",       "wls",    "--parameters",
                                        "mass-com", "--known", "rec.truth.json", "--json", "-"};
  auto withComparison = chosen;
  withComparison.push_back("--compare");
  const Outcome run = heft(withComparison);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  json result = json::parse(run.out), alone = json::parse(heft(chosen).out);
  const json comparison = result["comparison"];
  for (const char* key : {"comparison", "timing_s"}) {
    result.erase(key);
    alone.erase(key);
  }
  EXPECT_EQ(result, alone);

  std::vector<std::string> methods;
  for (const auto& row : comparison) {
    methods.push_back(row["method"]);
    EXPECT_EQ(row["schema"], "heft.estimate/1");
    EXPECT_EQ(row["parameters"], "mass-com");
    EXPECT_NEAR(row["payload"]["mass_kg"].get<double>(), alone["payload"]["mass_kg"].get<double>(), 0.02);
    EXPECT_TRUE(row["termination"]["usable"].get<bool>()) << row["termination"];
    EXPECT_GT(row["timing_s"]["total"], 0.0);
  }
  EXPECT_EQ(methods, kMethods);
  EXPECT_EQ(comparison[2]["payload"], alone["payload"]);
}

}  // namespace
}  // namespace heft::test
