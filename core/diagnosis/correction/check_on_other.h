#pragma once
// Whether what was found in one recording holds in another one of the same rig.
#include <string>

#include "core/diagnosis/result.h"

namespace heft {

/// Applies the causes of `report`, and its mistake of frames or signs if any, to another recording and fits bias and
/// payload only.
Result<DiagnosisReport::Check> checkOn(const DiagnosisReport& report, const Recording& other, const RobotModel* robot);
/// What came of it, in plain words.
std::string checkText(const DiagnosisReport::Check& check);

}  // namespace heft
