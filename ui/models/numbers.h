#pragma once
// Numbers as people read them: real minus, fixed decimals, space before the unit.
#include <QString>

namespace heft {

/// 45.8, −0.5; never −0.0.
QString numberText(double value, int decimals);

/// Decimals that an uncertainty of this size (same unit) leaves meaningful: two digits of it if it begins with 1, else
/// one. Never more than `most`.
int decimalsFor(double uncertainty, int most);

/// "11.20 s", "pose 3".
QString timeText(double time, bool poses);

}  // namespace heft
