#pragma once
// Segments of a recording with the smoothing that an estimate of it would choose.
#include "core/estimation/prepare.h"

namespace heft {

struct SegmentedRecording {
  Motion motion;
  Segmentation segmentation;
  bool usable = true;  ///< An estimate finds enough free motion in it.
  Findings findings;   ///< Of the motion and of the segmentation.
};

/// As `estimate` would see it, and with 25 Hz where nothing is left to estimate from. Fails for standing poses, which
/// have no segments, and where the motion cannot be worked out.
Result<SegmentedRecording> segmentRecording(const Recording& recording, const RobotModel* robot,
                                            const EstimateOptions& options, const Progress& progress = {});

/// heft.segment/1, without the findings: the segments and their sums.
nlohmann::json toJson(const SegmentedRecording& segmented, const Recording& recording);
std::string toText(const SegmentedRecording& segmented, const Recording& recording);

/// The payload of a result file (or a bare payload) as a first estimate; without standard deviations in it, as a value
/// good to 3 % and 5 mm.
Result<PayloadGuess> payloadGuessFromJson(const nlohmann::json& object, const std::string& where);

}  // namespace heft
