#pragma once
// Intervals for every number of a payload.
#include <array>

namespace heft {

struct Interval {
  double lower = 0.0, upper = 0.0;
};

/// Of mass [kg], centre of mass in S [m], and inertia about the centre of mass in S's axes [kg m2].
struct PayloadInterval {
  Interval mass;
  std::array<Interval, 3> com;
  std::array<std::array<Interval, 3>, 3> inertiaCom;
};

}  // namespace heft
