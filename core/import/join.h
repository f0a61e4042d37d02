#pragma once
// Streams of different clocks and rates become one recording.
#include <optional>
#include <vector>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/import/mapping.h"
#include "core/import/streams.h"
#include "core/recording/recording.h"

namespace heft {

/// `streams` hold the values of the chosen fields, in the conventions that the meta states; the recording's are in the
/// plain form, so that no average runs across the jump of an angle, and not yet checked. What was joined, shifted and
/// thinned is in the findings.
Result<Recording> joinStreams(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns,
                              const MappingWishes& wishes, RecordingMeta meta, Findings& findings);

/// Share of the force's variance that the motion explains, with any payload, mount and sign; nothing where the motion
/// cannot be told (no robot, too short).
std::optional<double> explainedByMotion(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns,
                                        const MappingWishes& wishes, RecordingMeta meta);

}  // namespace heft
