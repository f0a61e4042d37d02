#include <algorithm>

#include "core/import/demonstrations.h"
#include "core/import/mapping.h"
#include "core/import/target.h"

namespace heft {

std::vector<ColumnCandidate> rivalWrenches(const std::vector<Stream>& streams, const MappingWishes& wishes,
                                           const std::vector<ColumnSource>& chosen) {
  constexpr std::size_t kMost = 4;
  constexpr int kNearlyAsGood = 2;  // Scores that differ by less say nothing.
  std::vector<ColumnCandidate> out;
  const auto column = std::find_if(chosen.begin(), chosen.end(), [](const auto& c) { return c.column == "fx"; });
  if (column == chosen.end() || column->why == kSaidByUser || wishes.use.contains(kDemonstration)) return out;
  const auto candidates = findCandidates(streams, {});
  const auto is = [&](const ColumnCandidate& candidate) {
    return candidate.columns[0].stream == column->stream && candidate.columns[0].field == column->field;
  };
  const auto mine = std::find_if(candidates.begin(), candidates.end(), is);
  if (mine == candidates.end()) return out;
  for (const auto& candidate : candidates) {
    const auto& stream = streams[candidate.columns[0].stream];
    if (candidate.part != "wrench" || is(candidate) || candidate.score + kNearlyAsGood < mine->score ||
        stream.clockless != streams[column->stream].clockless || out.size() == kMost)
      continue;
    // Of several demonstrations the first one is read, whatever the others hold.
    if (stream.type.empty() && !demonstrationOf(stream, streams[column->stream]).empty()) continue;
    out.push_back(candidate);
  }
  return out;
}

}  // namespace heft
