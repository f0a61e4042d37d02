#pragma once
// What a diagnosis found, taken out of a recording one cause at a time, and the payload estimated with it.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/diagnosis/result.h"

namespace heft {

/// The recording as it is where its numbers mean what the mistake's reading says. Fails without the sensor's pose where
/// that is needed.
Result<Recording> undone(Recording recording, const RobotModel* robot, const diagnosis::FrameMistake& mistake);
/// `meta` as stated; `fromJoints`: the motion comes from joints, so that a mount may be corrected.
nlohmann::json mistakeToJson(const diagnosis::FrameMistake& mistake, const RecordingMeta& meta, bool fromJoints);

/// False for what can only be mended on the rig (a sensor at its limit), or is allowed for anyway (spikes).
bool canApply(const DiagnosisReport& report, const DiagnosedCause& cause);

/// `recording` without `causes` (IDs) of `found`, a heft.diagnose/1 that was made on it: their wrench is taken off,
/// frames are set right, contacts are marked, joint velocities that disagree with the angles are dropped. Fails if
/// `found` does not hold them. A cause in a form that this version does not know is an error, too, or, where `unknown`
/// is given, left in and its ID put there.
Result<Recording> corrected(const Recording& recording, const RobotModel* robot, const nlohmann::json& found,
                            const std::vector<std::string>& causes, std::vector<std::string>* unknown = nullptr);

/// `recording` without all that a result of heft diagnose accounts for, which was read from the file `where`. Of
/// another recording than the one that it was made on, what has a place in time stays, and the way that the zero took.
/// Fails if `found` is no such result.
Result<Recording> correctedByAll(const Recording& recording, const RobotModel* robot, const nlohmann::json& found,
                                 const std::string& where);

/// estimate() with the causes in the model: the payload comes from the corrected recording, its deviations are at least
/// those of the joint fit, and the simulated wrench holds what the causes add, so that it compares with the recording.
/// What another version of Heft saved and this one does not know stays out, and the findings say so.
Result<EstimateReport> estimateWith(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                                    const nlohmann::json& found, const std::vector<std::string>& causes,
                                    const Progress& progress = {});

}  // namespace heft
