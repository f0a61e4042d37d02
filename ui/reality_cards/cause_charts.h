#pragma once
// Small plots on a cause's card and in the report.
#include "ui/charts/chart.h"
#include "ui/controller/reality_findings.h"

namespace heft {

/// Error on the most telling held-out segment, before and after.
Chart errorChart(const DiagnosisReport& report, const DiagnosedCause& cause);
/// Measured, old and improved simulation on the same segment.
Chart overlayChart(const DiagnosisReport& report, const DiagnosedCause& cause);

}  // namespace heft
