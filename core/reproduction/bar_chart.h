#pragma once
// Grouped bar charts with a logarithmic axis, as SVG.
#include <string>
#include <vector>

namespace heft {

struct BarSeries {
  std::string name;
  std::vector<double> values;  ///< One a group, all above zero; NaN leaves a gap.
};

struct BarChart {
  std::string title, xTitle, yTitle;
  std::vector<std::string> groups;
  std::vector<BarSeries> series;
};

/// A complete SVG document with title, both axis titles, decades as grid and a legend. The lowest decade shown is at
/// most ten below the highest; smaller values are drawn as a stub.
std::string toSvg(const BarChart& chart);

}  // namespace heft
