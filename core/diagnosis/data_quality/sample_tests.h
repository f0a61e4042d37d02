#pragma once
// What single samples show, before any model: clipping, spikes, lost and repeated readings, velocities that lag.
#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/data_quality/coarse_readings.h"
#include "core/diagnosis/data_quality/dead_band.h"
#include "core/diagnosis/data_quality/direct.h"
#include "core/diagnosis/data_quality/held_rows.h"
#include "core/diagnosis/data_quality/time_stamps.h"
#include "core/motion/motion.h"
#include "core/recording/replayed.h"
#include "core/segmentation/flat_tops.h"

namespace heft::diagnosis {

/// What is known of the rows before they are judged.
struct RowFacts {
  std::optional<UnevenStamps> stamps;  ///< As of unevenStamps(recording)
  std::vector<FlatTop> tops;           ///< As of flatTops(its wrench)
  std::vector<bool> lost;              ///< To these: as of unclipped()
  std::vector<DeadBand> deadBands;     ///< As of deadBands(recording)
  CoarseReadings coarse;               ///< As of coarseReadings(recording)
  Eigen::Index spikes = 0;             ///< Rows in which readings were replaced: as of withoutSpikes()
  Eigen::Index loneSpikes = 0;         ///< Of these, those in which one channel leaps far and none with it
  std::vector<Held> held;              ///< As of heldRows(recording)
  Runs stale;                          ///< As of staleRuns(recording)
  std::vector<Replay> replayed;        ///< As of replayedStretches(), 20 readings and more
  Runs motionHeld;                     ///< As of motionHolds(recording)
  /// The wrench with what zeros, spikes, flat tops and steps hide put in again, as far as that can be told
  Eigen::Matrix<double, Eigen::Dynamic, 6> restored;
};

/// Of a recording as it was read.
RowFacts rowFactsOf(const Recording& recording);

/// Tests on a recording as it was read; `motion` as worked out from it.
std::vector<Direct> sampleTests(const Recording& recording, const Motion& motion, const RowFacts& facts);

}  // namespace heft::diagnosis
