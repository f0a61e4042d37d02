#pragma once
// Plots as inline SVG, for pages that fetch nothing and run no script.
#include <string>
#include <vector>

#include "core/math/rigid.h"

namespace heft::html {

/// A line over the plot's x.
struct Curve {
  const char* colour;
  const char* name;
  VectorXd y;  ///< As long as x; NaN: a gap
  double width;
};

struct Axis {
  std::string title, unit;  ///< An empty unit is not shown
  bool logarithmic = false;
};

/// Curves over a rising x.
std::string plot(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Curve>& curves);

/// Points over the cloud's x.
struct Cloud {
  const char* colour;
  const char* name;
  VectorXd y;  ///< As long as x; NaN: no point
};

/// Points; of many, some.
std::string scatter(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Cloud>& clouds);

}  // namespace heft::html
