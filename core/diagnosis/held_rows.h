#pragma once
// Stretches in which nothing new came from the sensor, or from anything.
#include <vector>

#include "core/recording/recording.h"

namespace heft::diagnosis {

/// Rows [from, to) whose wrench repeats the row before.
struct Held {
  Eigen::Index from = 0, to = 0;
  bool motionToo = false;  ///< The motion stood still with it: whole rows were repeated.
};

/// Stretches of 15 ms and five times as long as the wrench usually repeats: it was held. A sensor that is polled slowly
/// repeats often and briefly. None where they make up more than a quarter of the recording.
std::vector<Held> heldRows(const Recording& recording);

/// The motion of whole rows that were repeated put back: a cubic through two rows on either side.
void bridge(Recording& recording, const std::vector<Held>& held);

}  // namespace heft::diagnosis
