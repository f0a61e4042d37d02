#pragma once
// Stretches in which the wrench is not what the sensor felt.
#include <string>
#include <vector>

#include "core/recording/recording.h"

namespace heft {

struct Trouble {
  double from = 0, to = 0;  ///< [s]
  std::string reason;
};

/// The whole wrench hung (no channel changes for 50 ms and twenty times longer than usual), or a channel is cut off at
/// the end of its range (flatTops()) for 10 ms or more.
std::vector<Trouble> sensorTrouble(const Recording& recording);

}  // namespace heft
