#pragma once
// What a motion would tell that has not been made yet, from the information so far and the noise seen so far.
#include "core/coach/guided_tool.h"
#include "core/online/online_estimator.h"
#include "core/online/online_information.h"

namespace heft {

enum class CoachGoal { mass, com, inertia };
std::string_view toString(CoachGoal quantity);  ///< "mass", "com", "inertia", as in parameter sets and options
std::optional<CoachGoal> quantityFromString(std::string_view text);

/// Standard deviations, in one number each.
struct Uncertainty {
  double mass = 0.0;     ///< [kg]
  double com = 0.0;      ///< Of the worst of the three coordinates [m]
  double inertia = 0.0;  ///< Of the worst of the three moments, relative
  double of(CoachGoal quantity) const;
};

/// Of the information itself (Laplace approximation at its estimate).
Uncertainty uncertaintyOf(const OnlineInformation& information);

/// What `motion` would add: its regressor rows whitened by the noise model, as if the sensor went on as before and the
/// present estimate were right. Fails nowhere: a motion that is too short adds nothing.
Triangle rowsOfMotion(const OnlineInformation& information, const GuidedTool& tool, const Vector3d& gravity,
                      const JointMotion& motion);
/// The information with such rows added.
OnlineInformation informationWith(const OnlineInformation& information, const Triangle& rows);

/// "centre of mass ± 4.0 mm -> ± 1.0 mm" (95 %).
std::string gainWords(CoachGoal quantity, const Uncertainty& before, const Uncertainty& after);

/// The same from a whole recording: the batch's preparation. Needs kind "motion". `segments` gets what was free.
Result<OnlineInformation> informationOf(const Recording& recording, const RobotModel* robot,
                                        const std::optional<Shape>& shape, std::vector<Segment>* segments = nullptr);

}  // namespace heft
