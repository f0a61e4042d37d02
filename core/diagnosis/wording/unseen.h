#pragma once
// What a motion could not have shown, in the language of now.
#include <string>
#include <vector>

#include "core/diagnosis/result.h"

namespace heft {

/// "delays under 0.4 ms" and the like, those that people look for first; at most `most`.
std::vector<std::string> couldNotBeSeen(const std::vector<Smallest>& smallest, int most);

}  // namespace heft
