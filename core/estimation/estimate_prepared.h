#pragma once
// The second half of an estimate: from a prepared recording to a result.
#include "core/estimation/estimate.h"
#include "core/estimation/prepare.h"

namespace heft {

/// prepare() as the method needs it. Fails for a senseless trim.
Result<Prepared> prepareFor(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                            const Progress& progress);

/// `others` are the triangles of other recordings of the same tool with their own biases eliminated (zero in the bias
/// columns): they add to what is known of the payload. Only the method map looks at them.
Result<EstimateReport> estimatePrepared(const Recording& recording, const Prepared& prepared,
                                        const EstimateOptions& options, const std::vector<Triangle>& others,
                                        double prepareSeconds, const Progress& progress);

}  // namespace heft
