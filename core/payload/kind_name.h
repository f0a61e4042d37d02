#pragma once
#include <string>

#include "core/payload/shape.h"

namespace heft {

/// "box", in the language of the program; toString() gives what stands in files.
std::string kindName(BodyKind kind);

}  // namespace heft
