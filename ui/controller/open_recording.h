#pragma once
// Reading a recording with its robot: the work of a job.
#include "core/base/progress.h"
#include "core/base/result.h"
#include "ui/controller/workspace.h"

namespace heft {

/// If it fails, `cure` says what the user can do.
Result<std::shared_ptr<const OpenRecording>> loadRecording(const QString& path, const Progress& progress,
                                                           ReadCure& cure);

}  // namespace heft
