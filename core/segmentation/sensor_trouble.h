#pragma once
// Stretches in which the wrench is not what the sensor felt.
#include <string>
#include <vector>

#include "core/recording/recording.h"
#include "core/segmentation/flat_tops.h"

namespace heft {

struct Trouble {
  double from = 0, to = 0;  ///< [s]
  std::string reason;
};

/// The whole wrench hung (no channel changes for 50 ms and twenty times longer than usual), one channel did
/// (frozenAlone()), the posture did (hungPostures()), nothing was recorded (rows are missing for more than 20 ms: what
/// lies between was made up), readings came once more (replayedStretches()), or a channel is cut off at the end of its
/// range (flatTops()) in three rows or more with at most 40 ms between them. Of a channel that is cut off in most rows
/// (mostlyCutOff()) nothing is said. Where the posture hung or leaps (postureLeaps()), kAroundLeap to either side
/// counts, too. `tops`: flatTops() of its wrench.
std::vector<Trouble> sensorTrouble(const Recording& recording, const std::vector<FlatTop>& tops);
std::vector<Trouble> sensorTrouble(const Recording& recording);

}  // namespace heft
