#pragma once
// What the controller's current entry costs, in words and numbers, computed without widgets.
#include <QString>
#include <vector>

#include "core/compensation/entry_cost.h"
#include "ui/models/result_text.h"

namespace heft {

struct EntryText {
  enum class Grade { right, costs, stops } grade = Grade::right;
  QString headline;     ///< "The controller feels up to 2.9 N that nobody exerts."
  QString consequence;  ///< What that does to collisions and to a compliant arm
  std::vector<DetailText> rows;
  QString note;  ///< What was taken as estimated; may be empty
};

EntryText describeEntry(const EntryCost& cost, const ControllerLimits& limits);

}  // namespace heft
