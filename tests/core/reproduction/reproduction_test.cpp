#include "core/reproduction/reproduction.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace heft {
namespace {

using testing::HasSubstr;

ReproductionOptions small(std::uint64_t seed) {
  ReproductionOptions options;
  options.seed = seed;
  options.repeats = 1;
  options.scale = 0.4;
  options.rateHz = 200.0;
  options.timingRuns = 1;
  return options;
}

const Reproduction& once() {
  static const Reproduction all = [] {
    auto options = small(1);
    options.uncompressed = true;
    return *reproducePaper(options);
  }();
  return all;
}

/// Everything but the clock.
nlohmann::json withoutTimes(const Reproduction& all) {
  auto json = toJson(all);
  json.erase("runtimes");
  json.erase("explanation");
  return json;
}

TEST(Paper, PrintsNoInertiaWhereItEstimatedNone) {
  EXPECT_EQ(paperError(Method::ceres, ParameterSet::full, Quantity::inertia, DataKind::measured), 1232.35);
  EXPECT_EQ(paperError(Method::eigenLm, ParameterSet::mass, Quantity::mass, DataKind::validation), 0.00139);
  EXPECT_FALSE(paperError(Method::ceres, ParameterSet::mass, Quantity::com, DataKind::measured));
  EXPECT_FALSE(paperError(Method::map, ParameterSet::mass, Quantity::mass, DataKind::measured));
  EXPECT_EQ(paperTime(Method::tlsFast, ParameterSet::full)->seconds, 71.0 * 3600.0);
  EXPECT_TRUE(paperTime(Method::ceres, ParameterSet::mass)->below);
  EXPECT_FALSE(paperTime(Method::tlsExact, ParameterSet::full));
}

TEST(Reproduction, HasThePapersLines) {
  const auto& all = once();
  ASSERT_EQ(all.errors.size(), 2u);
  for (const auto& table : all.errors) {
    EXPECT_EQ(table.rows.size(), 12u);
    EXPECT_EQ(table.recordings, table.handGuided ? 2 : 3);
    for (const auto& row : table.rows) {
      EXPECT_EQ(row.paperCeres.has_value(), !table.handGuided);
      // Two solvers of the same least squares must agree where both run to the end.
      EXPECT_NEAR(row.ceres, row.eigenLm, 1e-3 * row.ceres + 1e-6);
    }
  }
  EXPECT_EQ(all.runtimes.size(), 9u);
  for (const auto& row : all.runtimes)
    for (std::size_t p = 0; p < kParameterSets.size(); ++p) {
      EXPECT_GT(row.solve[p], 0.0);
      EXPECT_GE(row.total[p], row.solve[p]);
      EXPECT_EQ(row.uncompressed[p].has_value(), row.method != Method::map);
    }
}

TEST(Reproduction, BiasExplainsThePapersMassErrorAndHeftRemovesIt) {
  const auto& causes = once().causes;
  ASSERT_EQ(causes.size(), 5u);
  const auto &noise = causes[0], &bias = causes[1], &all = causes[4];
  EXPECT_EQ(bias.cause, "bias");
  EXPECT_GT(bias.paper.mass, 10.0 * noise.paper.mass);
  EXPECT_NEAR(bias.paper.mass, all.paper.mass, 0.2 * all.paper.mass);
  // A bias that is estimated along costs Heft nothing, whatever its size.
  EXPECT_NEAR(bias.heft.mass, noise.heft.mass, 0.01 * noise.heft.mass + 1e-4);
  EXPECT_LT(all.heft.inertia, 0.1 * all.paper.inertia);
}

TEST(Reproduction, IsDeterministicAndSeeded) {
  const auto again = *reproducePaper(small(1));
  auto first = withoutTimes(once());
  EXPECT_EQ(first, withoutTimes(again));
  EXPECT_NE(first["errors"], withoutTimes(*reproducePaper(small(2)))["errors"]);
}

TEST(Reproduction, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const auto result = reproducePaper(small(1), Progress{source.get_token(), {}});
  ASSERT_FALSE(result.ok());
  EXPECT_TRUE(result.error().cancelled);
}

TEST(Reproduction, WritesTheSameNumbersInEveryForm) {
  const auto& all = once();
  const double mass = all.errors[0].rows[3].heft;
  EXPECT_THAT(toText(all), HasSubstr("1.23e+03"));
  EXPECT_THAT(toMarkdown(all), HasSubstr("\n|---|---:"));
  EXPECT_THAT(toCsv(all), HasSubstr("errors-predefined,mass,mass,measured,,paper,ceres,0.04469,1\n"));
  EXPECT_THAT(toCsv(all), HasSubstr("runtimes,full,solve,measured,,paper,tls-fast,255600,s\n"));
  const auto json = toJson(all);
  EXPECT_EQ(json["schema"], "heft.reproduce/1");
  EXPECT_EQ(json["errors"][3]["heft"], mass);
  EXPECT_EQ(json["explanation"].size(), explain(all).size());
  const auto charts = chartsOf(all);
  ASSERT_EQ(charts.size(), chartFiles().size());
  for (std::size_t i = 0; i < charts.size(); ++i) {
    EXPECT_EQ(charts[i].file, chartFiles()[i]);
    EXPECT_FALSE(charts[i].chart.xTitle.empty() || charts[i].chart.yTitle.empty());
    for (const auto& series : charts[i].chart.series)
      EXPECT_EQ(series.values.size(), charts[i].chart.groups.size()) << charts[i].file << " " << series.name;
  }
}

// Of a reproduction in which delay, not bias, did the harm, the sentences must say so.
TEST(Reproduction, ExplainsTheNumbersItIsGiven) {
  Reproduction all = once();
  all.causes[2].paper.mass = 0.5;
  all.causes[1].paper.mass = 0.001;
  std::string text;
  for (const auto& sentence : explain(all)) text += sentence + "\n";
  EXPECT_THAT(text, HasSubstr("error of the mass: noise alone"));
  EXPECT_THAT(text, HasSubstr("with one cause on top: delay 50 %, "));
}

}  // namespace
}  // namespace heft
