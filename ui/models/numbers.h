#pragma once
// Numbers as people read them: real minus, fixed decimals, space before the unit.
#include <QString>

#include "core/base/numbers.h"  // decimalsFor()

namespace heft {

/// 45.8, −0.5; never −0.0.
QString numberText(double value, int decimals);

/// "11.20 s", "pose 3".
QString timeText(double time, bool poses);

}  // namespace heft
