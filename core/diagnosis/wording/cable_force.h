#pragma once
// What a cable or hose does to the tool, told by the parameters of the cause "cable_pull".
#include <optional>
#include <string_view>
#include <vector>

#include "core/diagnosis/result.h"
#include "core/diagnosis/wording/views.h"

namespace heft::diagnosis {

/// Where a cable pulls to.
struct Pull {
  Vector3d anchor = Vector3d::Zero();  ///< Where it is fixed or, where that was not found itself, where its force would
                                       ///< be none, B axes [m]
  double anchorStd = 0.0;              ///< Largest of the three deviations [m]
  double force = 0.0;                  ///< How hard it pulls, on average over the motion [N]
};

/// None where a cable is too soft along some axis to tell a place, or where `witnesses` (those of the same recording)
/// lack the tool's position.
std::optional<Pull> pullOf(const DiagnosedCause& cable, const std::vector<Witness>& witnesses);

}  // namespace heft::diagnosis
