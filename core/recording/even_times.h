#pragma once
// How evenly samples are stamped.
#include <vector>

namespace heft {

struct StampScatter {
  double off = 0.0;   ///< Standard deviation of the stamps about even ones, by what 9 of 10 keep [s]; 0: not known yet
  double step = 0.0;  ///< The even step [s]
};

/// Of the times between samples that follow each other [s], oldest first; 200 at least are needed. Lost samples are no
/// scatter where the other steps are even; a pause of more than a quarter of a second is none, and what lies before it
/// does not count. A clock that runs too fast or too slow is none.
StampScatter stampScatter(std::vector<double> steps);

}  // namespace heft
