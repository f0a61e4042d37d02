#pragma once
// From the estimate on screen to a payload file for a controller.
#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/estimation/estimate.h"
#include "core/exporters/exporter.h"
#include "ui/controller/workspace.h"

namespace heft {

/// Text of the file in `format`, in flange axes. `findings` tells what of it was not measured and what was assumed.
/// Fails where the sensor's place on the flange is not known or the numbers are not physical.
Result<std::string> payloadFile(const OpenRecording& opened, const EstimateReport& report, const ExportFormat& format,
                                Findings& findings);

}  // namespace heft
