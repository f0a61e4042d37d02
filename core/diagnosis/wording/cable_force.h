#pragma once
// What a cable or hose does to the tool, told by the parameters of the cause "cable_pull".
#include <optional>
#include <string_view>
#include <vector>

#include "core/diagnosis/result.h"
#include "core/diagnosis/wording/views.h"

namespace heft::diagnosis {

/// Symmetric, in the parameters' axes and unit: `what`, such as "stiffness" [N/m, B axes], alike to all sides, or along
/// each axis and, where it has them, across two. `ending`: what follows the parameters' names where a cause has several
/// terms.
Matrix3d tensorOf(std::string_view what, const std::vector<CauseParameter>& parameters, std::string_view ending = {});

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
