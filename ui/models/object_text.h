#pragma once
// What is said about an object that the tool carries, as plain data.
#include <QString>
#include <vector>

#include "core/estimation/carried_object.h"
#include "ui/models/result_text.h"

namespace heft {

struct ObjectText {
  QString headline;  ///< "It weighs 0.312 ± 0.004 kg."
  QString note;      ///< When it was picked up, or why there is no estimate
  bool sure = false;
  std::vector<DetailText> rows;  ///< Mass, centre, inertia with intervals; empty unless it was found
  std::vector<FindingText> findings;
};

ObjectText describeObject(const CarriedObject& carried);

}  // namespace heft
