#pragma once
// Two readings of standing poses fit alike: the pose in which they part.
#include <optional>
#include <string>

#include "core/coach/guided_tool.h"
#include "core/conventions/check.h"
#include "core/recording/recording.h"

namespace heft {

struct DecidingPose {
  VectorXd q;          ///< Joint target [rad]
  double apart = 0.0;  ///< How far apart the two expect the wrench, in standard deviations of what is known of it
};

/// The two readings that fit best, where `report`, of this recording, says that more than one does.
struct TiedReadings {
  conventions::Reading first, second;
  std::string firstSaid, secondSaid;  ///< A sentence each
};
std::optional<TiedReadings> tiedReadings(const conventions::Report& report);

/// Reached by the last three joints from `from`, within their ranges. Nothing where the two expect the same wrench in
/// all of these: exact ties; or where the arm cannot go straight and clear of everything to one that decides. `poses`:
/// with joints, in plain form.
std::optional<DecidingPose> decidingPose(const Recording& poses, const GuidedTool& tool, const TiedReadings& tied,
                                         const VectorXd& from, const Clearance* clearance = nullptr);

}  // namespace heft
