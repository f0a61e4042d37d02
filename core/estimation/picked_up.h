#pragma once
// One recording in which something is picked up or put down, as two: with it and without it.
#include "core/base/progress.h"
#include "core/estimation/carried_object.h"
#include "core/estimation/options.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

struct PickedUp {
  Recording with, without;         ///< The whole recording, the other parts marked to be ignored
  std::vector<double> pickedUpAt;  ///< [s]
  std::vector<double> putDownAt;   ///< [s]
};

/// Finds the moments by segmentation. Fails where the payload never changes, where it changes in one direction twice in
/// a row (then there are more than two payloads), and like segmentRecording().
Result<PickedUp> partsWithAndWithout(const Recording& recording, const RobotModel* robot,
                                     const EstimateOptions& options, const Progress& progress = {});

/// estimateCarriedObject() of the two parts; the moments are told among the findings of `with`, codes "picked_up" and
/// "put_down". `read`: what was said when the recording was read.
Result<CarriedObject> estimatePickedUp(const JointInput& recording, const EstimateOptions& options,
                                       const Findings& read = {}, const Progress& progress = {});

}  // namespace heft
