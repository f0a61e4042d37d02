#pragma once
// The channels of a wrench.
#include <Eigen/Core>

namespace heft {

/// The name of channel c: "fx" .. "tz".
inline const char* channelName(Eigen::Index c) {
  constexpr const char* kNames[] = {"fx", "fy", "fz", "tx", "ty", "tz"};
  return kNames[c];
}

}  // namespace heft
