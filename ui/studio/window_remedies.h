#pragma once
// How to do in the window what core's remedies ask for.
#include <string>

#include "core/base/remedy.h"

namespace heft {

/// For setRemedyWords(). Names of menu entries stand as they are in the menus.
std::string windowRemedy(Remedy way, const std::string& subject);

}  // namespace heft
