#pragma once
// What the controller was told that it carries, beside the estimate. Private to core/estimation.
#include <nlohmann/json_fwd.hpp>

#include "core/estimation/estimate.h"

namespace heft {

/// Adds a finding that says by how much the controller's payload differs, in mass and, where the sensor's mount names
/// the flange, in the centre of mass. Nothing where the recording does not tell it, or the estimate cannot be trusted.
void compareWithConfigured(EstimateReport& report);

/// {"source", "frame": "flange", "changed", "payload": {...}, "difference": {"mass_kg", "com_m"}}: the controller's
/// minus the estimate's, in the flange's axes. Only where report.configured has a mass.
nlohmann::json configuredJson(const EstimateReport& report);

}  // namespace heft
