#pragma once
// Causes as they are drawn on the arm.
#include <vector>

#include "ui/controller/diagnosis.h"
#include "ui/robot_view/cause_mark.h"

namespace heft {

/// Those of the report that act at a place or along a direction; a cable has a mark of its own.
std::vector<CauseMark> causeMarks(const DiagnosisReport& report);

}  // namespace heft
