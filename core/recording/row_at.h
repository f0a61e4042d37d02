#pragma once
// Where a time is in a recording.
#include <algorithm>

#include "core/math/rigid.h"

namespace heft {

/// The first row at or after `time` [s] of those recorded at `times` (N, rising); N where there is none.
inline Eigen::Index rowAt(const VectorXd& times, double time) {
  return std::lower_bound(times.begin(), times.end(), time) - times.begin();
}

}  // namespace heft
