#pragma once
// How one does in the window what core asks for.
#include <string>

#include "core/base/remedy.h"

namespace heft {

/// For setRemedyWords(). Names of menu entries stand as they are in the menus.
std::string windowRemedy(Remedy way, const std::string& subject);

}  // namespace heft
