#pragma once
// From the estimate on screen to a payload file for a controller.
#include <string>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/estimation/estimate.h"
#include "core/exporters/exporter.h"
#include "core/workspace/session.h"
#include "ui/controller/workspace.h"

namespace heft {

struct PayloadFile {
  std::string text;
  Payload onFlange;   ///< What the file states: tool and mounted parts together, F axes.
  Findings findings;  ///< What of it was not measured, what was assumed, what the format cannot hold.
};

/// The file that `choice` asks for, in flange axes. Fails where the sensor's place on the flange is not known, the
/// numbers are not physical, cannot be trusted without being `confirmed`, or the format does not exist.
/// `cautions`: what else speaks against the numbers, for the file's remarks.
Result<PayloadFile> payloadFile(const OpenRecording& opened, const EstimateReport& report, const ExportChoice& choice,
                                const std::vector<std::string>& cautions = {}, bool confirmed = false);

}  // namespace heft
