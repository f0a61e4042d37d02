#pragma once
// What no cause of the catalogue accounts for, beside what goes with the motion (structure.h).
#include <optional>
#include <vector>

#include "core/diagnosis/calibration.h"
#include "core/diagnosis/data_quality/dead_band.h"
#include "core/diagnosis/data_quality/stuck_bit.h"
#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

/// What single readings tell.
struct ByReadings {
  bool known = false;        ///< Something is wrong with them
  bool coarse = false;       ///< Blocks are too long for what is fast: that is asked of a part of the recording
  bool withinSteps = false;  ///< No more is left over than their steps make of themselves
  std::vector<DeadBand> deadBands = {};
  std::vector<StuckBit> stuckBits = {};
  std::optional<FrozenChannel> frozen = {};
  Eigen::Index leaps = 0;  ///< Rows that leap and are neither spikes nor of a stuck bit
};

struct WhatRemains {
  Structure structure;   ///< That the verdict counts; gain <= 0: nothing
  Findings findings;     ///< What is said of it, and of what is no matter of the verdict
  bool claimed = false;  ///< Some hypothesis about what the catalogue lacks holds, beyond what was known
  bool seen = false;     ///< The structure was seen: its gain is just large, and no evidence to compare with
};

/// Asks each hypothesis about what the catalogue lacks, in the order of the table there. `structure`: what is known to
/// go with the motion.
WhatRemains whatRemains(const Hypothesis& hypothesis, const Recording& cleaned, const ByReadings& by,
                        const Structure& structure);

}  // namespace heft::diagnosis
