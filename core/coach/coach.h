#pragma once
// Which motion helps most now: in words, as a joint motion, and with the gain that it promises.
//
// Candidates turn the tool about its centre of mass: slow tilts, turns about its long axis, swings, shakes of 2 to 4
// Hz. Each is scaled down until it keeps every limit, and judged by the information that it would add. Obstacles are
// not known: who guides or replays the motion has to see that the way is free.
#include <string_view>

#include "core/coach/prediction.h"

namespace heft {

struct Advice {
  bool needed = true;                ///< False: everything is well known, `sentence` says so and the rest is empty.
  std::string id;                    ///< Stable name of the motion, "tilt-sideways"
  std::string sentence;              ///< "Tilt the tool sideways, slowly."
  CoachGoal about = CoachGoal::com;  ///< What it helps.
  std::string gain;  ///< "centre of mass ± 4.0 mm -> ± 1.0 mm"; empty while there is no estimate to promise from
  Uncertainty before, after;
  JointMotion motion;  ///< From the present posture and back, at rest at both ends; for a ghost or a replay
  VectorXd target;     ///< The posture in it that is turned furthest from the present one
  LimitUse use;        ///< How far it uses the limits
};

struct CoachOptions {
  std::optional<CoachGoal> want;  ///< Absent: what is worst known compared with what a controller needs.
  MotionLimits limits;
  double duration = 5.0;  ///< Of a proposed motion, at most [s]
};

/// The best motion from posture `q`. `information` may be absent (nothing known yet). About 0.2 s of work: call it when
/// the advice is to change, not at every refresh. Fails if the posture is outside the joints' ranges or no candidate
/// keeps the limits; throws std::invalid_argument if q has not dof() entries.
Result<Advice> advise(const std::optional<OnlineInformation>& information, const GuidedTool& tool,
                      const Vector3d& gravity, const VectorXd& q, const CoachOptions& options = {});

/// The coach's motion of that name ("shake-sideways") from posture `q` and back, as large as the limits allow; without
/// a promise of what it brings. About 20 ms of work. Fails like advise(), and if there is no such motion.
Result<Advice> namedMotion(std::string_view id, const GuidedTool& tool, const VectorXd& q,
                           const CoachOptions& options = {});

}  // namespace heft
