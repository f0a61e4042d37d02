#pragma once
// Numbers as people read them.
#include <string>

namespace heft {

/// "45.8", "−0.5", never "−0.0": a real minus, and the decimal point of the language (core/base/say.h). A dash for what
/// is not finite.
std::string sayNumber(double value, int decimals);

/// Decimals that an uncertainty of this size (same unit) leaves meaningful: two digits of it if it begins with 1, else
/// one. Never more than `most`.
int decimalsFor(double uncertainty, int most);

}  // namespace heft
