#pragma once
// Streams of different clocks and rates become one recording.
#include <vector>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/import/mapping.h"
#include "core/import/streams.h"
#include "core/recording/recording.h"

namespace heft {

/// `streams` hold the values of the chosen fields. The recording is not yet checked; what was joined, shifted and
/// thinned is in the findings.
Result<Recording> joinStreams(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns,
                              const MappingWishes& wishes, RecordingMeta meta, Findings& findings);

}  // namespace heft
