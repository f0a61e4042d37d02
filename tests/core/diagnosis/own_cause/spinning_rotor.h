#pragma once
#include <memory>

#include "core/diagnosis/model/cause.h"

namespace heft::diagnosis {

std::unique_ptr<Cause> makeSpinningRotor();

}  // namespace heft::diagnosis
