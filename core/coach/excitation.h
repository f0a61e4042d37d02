#pragma once
// A small multi-sine on top of a taught motion for its replay by the robot (after Farsoni et al. 2017, as the seed
// paper suggests): the task stays what it is, and its free parts tell more about the tool.
#include "core/coach/prediction.h"
#include "core/online/online_information.h"

namespace heft {

struct ExcitationOptions {
  MotionLimits limits;
  double amplitude = 0.10;           ///< Of a joint at most [rad]
  double deviation = 0.02;           ///< Of the tool's points from the taught path at most [m]
  double lowHz = 0.6, highHz = 3.0;  ///< Of the sines
};

struct ExcitedMotion {
  JointMotion taught;   ///< The demonstration as it would be replayed: smoothed, from rest to rest, inside the limits
  JointMotion excited;  ///< With the sines
  double slowed = 1.0;  ///< The taught motion had to take so many times its duration to keep the limits
  double amplitude = 0.0;  ///< Largest that a joint deviates [rad]
  double deviation = 0.0;  ///< Largest that the tool's points deviate [m]
  LimitUse use;
  std::vector<Segment> free;  ///< Where the sines are, on the replay's clock
  Uncertainty now;            ///< From the demonstration alone
  Uncertainty replayed;       ///< After a replay of the taught motion
  Uncertainty after;          ///< After a replay with the sines
};

/// `segments` say what of the recording is free; sines fade in and out inside these parts and never touch the others.
/// Fails without joints, if the taught path leaves the joints' ranges, or if no free part is at least 1.5 s long.
Result<ExcitedMotion> excite(const Recording& recording, const GuidedTool& tool, const std::vector<Segment>& segments,
                             const OnlineInformation& information, const ExcitationOptions& options = {});

}  // namespace heft
