#include "core/reproduction/bar_chart.h"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>

namespace heft {
namespace {

using testing::HasSubstr;
using testing::Not;

BarChart sample() {
  return {"A & B", "method", "time, s", {"one", "two"}, {{"paper", {1.0, std::nan("")}}, {"ours", {0.01, 100.0}}}};
}

/// Heights of the bars, which are the rectangles that carry a title.
std::vector<double> heights(const std::string& svg) {
  const std::regex bar("height=\"([0-9.]+)\" fill=\"[^\"]*\"><title>");
  std::vector<double> out;
  for (std::sregex_iterator i(svg.begin(), svg.end(), bar), end; i != end; ++i) out.push_back(std::stod((*i)[1]));
  return out;
}

TEST(BarChart, NamesTitleAxesGroupsAndSeries) {
  const std::string svg = toSvg(sample());
  for (const char* text : {"A &amp; B", ">method<", ">time, s<", ">one<", ">two<", ">paper<", ">ours<"})
    EXPECT_THAT(svg, HasSubstr(text));
  EXPECT_THAT(svg, Not(HasSubstr("A & B")));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(BarChart, EveryDecadeHasTheSameHeightAndGapsStayEmpty) {
  const auto bars = heights(toSvg(sample()));  // one: 1 and 0.01; two: a gap and 100
  ASSERT_EQ(bars.size(), 3u);
  EXPECT_NEAR(bars[2] - bars[0], bars[0] - bars[1], 0.2);
  EXPECT_GT(bars[1], 0.0);
}

TEST(BarChart, StandsWithoutAnyValue) {
  BarChart chart = sample();
  for (auto& series : chart.series) series.values = {0.0, std::nan("")};
  const std::string svg = toSvg(chart);
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_TRUE(heights(svg).empty());
}

}  // namespace
}  // namespace heft
