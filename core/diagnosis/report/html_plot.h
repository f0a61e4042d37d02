#pragma once
// Plots as inline SVG, for pages that fetch nothing and run no script.
#include <string>
#include <vector>

#include "core/math/rigid.h"

namespace heft::html {

struct Axis {
  std::string title, unit;  ///< An empty unit is not shown
  bool logarithmic = false;
};

/// What is drawn over x, as a line or as points.
struct Series {
  const char* colour;
  const char* name;
  VectorXd y;    ///< As long as x; NaN: a gap, or no point
  double width;  ///< Of the line, or of a point
};

/// Lines over a rising x.
std::string plot(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Series>& lines);

/// Points; of many, some.
std::string scatter(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Series>& clouds);

}  // namespace heft::html
