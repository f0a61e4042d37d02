#pragma once
// Stretches in which nothing new came from the sensor, or from anything.
#include <utility>
#include <vector>

#include "core/recording/recording.h"
#include "core/recording/wrench_runs.h"

namespace heft::diagnosis {

/// Rows [from, to) whose wrench repeats the row before.
struct Held {
  Eigen::Index from = 0, to = 0;
  bool motionToo = false;  ///< The motion stood still with it: whole rows were repeated.
};

/// Stretches of 15 ms and five times as long as the wrench usually repeats: it was held. A sensor that is polled slowly
/// repeats often and briefly. None where they make up more than a quarter of the recording.
std::vector<Held> heldRows(const Recording& recording);

/// Runs of rows [from, to) that repeat the reading before them, which was held back: nearly all channels have moved on
/// when the next one comes. A smooth signal in coarse steps repeats, too, but goes on by a step in one channel or two.
/// None if channels that stand still independently of each other would make a third as many.
Runs staleRuns(const Recording& recording);

/// Runs of rows [from, to) in which the recorded motion stands still for 4 ms and more while the readings go on, and
/// then makes up for it at once: whatever reported it had stalled. None if these make up more than a twentieth of the
/// recording.
Runs motionHolds(const Recording& recording);

/// Runs of rows [from, to) in which all readings are zero, as a driver writes where it has nothing; none if there are
/// fewer than three such rows.
Runs zeroRuns(const Recording& recording);

/// Cubics through fresh readings in `cleaned`, where those of `recording` are `stale`. Not where the motion was held
/// with them: then both are equally old; and not where most are held for long.
void refresh(Recording& cleaned, const Recording& recording, Runs stale, const std::vector<Held>& notJudged);

/// The motion of whole rows that were repeated, or of those in which it alone was held, put back: a cubic through two
/// rows on either side.
void bridge(Recording& recording, const std::vector<Held>& held, const Runs& motionHeld);

}  // namespace heft::diagnosis
