#pragma once
// Plots as inline SVG, for pages that fetch nothing and run no script.
#include <string>
#include <vector>

#include "core/math/rigid.h"

namespace heft::html {

/// Room between what is drawn and the edge of the picture is for ticks; positions are in units of the picture.
struct Curve {
  const char* colour;
  const char* name;
  VectorXd y;  ///< As long as the plot's x; NaN: a gap
  double width;
};

struct Axis {
  std::string title, unit;
  bool logarithmic = false;
};

/// Curves over a rising x.
std::string plot(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Curve>& curves);

struct Cloud {
  const char* colour;
  const char* name;
  VectorXd y;  ///< As long as the cloud's x; NaN: no point
};

/// Points; of many, some.
std::string scatter(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Cloud>& clouds);

}  // namespace heft::html
