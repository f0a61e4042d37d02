#pragma once
// The estimate of one recording, or of several recordings of one tool at once: the work of a job.
#include "core/base/progress.h"
#include "core/base/result.h"
#include "ui/controller/workspace.h"

namespace heft {

/// A report for each of `of`, in their order. Several are joined (core/estimation/joint): all reports then hold the
/// joint numbers, and say so; a recording that is left out holds its own. Recordings with corrections are left out.
Result<SharedReports> estimateTogether(const std::vector<Snapshot>& of, const Progress& progress);

}  // namespace heft
