#pragma once
// How much the usual force/torque sensors measure, by the model's name.
#include <optional>
#include <string_view>

#include "core/math/rigid.h"

namespace heft::diagnosis {

/// Largest force [N] and torque [N m] of each channel in S axes, either way, by the maker's data sheet. `model`: the
/// setup file's, such as "Schunk FT Gamma SI-32-2.5"; case, spaces and dashes do not matter. Of a model whose
/// calibration is not stated: the largest that it is sold with. None where the model is unknown.
std::optional<Vector6d> sensorRange(std::string_view model);

}  // namespace heft::diagnosis
