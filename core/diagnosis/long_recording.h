#pragma once
// Recordings of minutes: causes are looked for in a part that tells much, and confirmed on the whole in coarser steps.
#include <optional>
#include <vector>

#include "core/diagnosis/residual_analysis/structure.h"
#include "core/diagnosis/smoothing_search.h"

namespace heft::diagnosis {

struct SearchedPart {
  Searched found;
  Recording cleaned;    ///< Its rows of Readings::cleaned
  Structure remaining;  ///< Beside what holds there, once that was asked
};

/// What was searched of a recording, and of a long one what its part showed.
struct SearchedInParts {
  Searched whole;                   ///< Of a short recording the only one
  std::vector<SearchedPart> parts;  ///< Of a long one, in fine steps
};

/// Of a long recording, what its parts alone were asked.
Findings findingsOf(const SearchedInParts& searches);

/// As searched(). What acts all the time and shows neither in a part of a long recording nor as a rival there is not
/// looked for in the whole.
Result<SearchedInParts> searchedAtAnyLength(const Recording& recording, const Readings& readings,
                                            const RobotModel* robot, const DiagnoseOptions& options,
                                            const Progress& progress);

/// Searches the part as well in which the whole leaves most, and the whole once more with what shows there.
std::optional<Error> searchWorstPart(const Recording& recording, const Readings& readings, const RobotModel* robot,
                                     const DiagnoseOptions& options, const Progress& progress, SearchedInParts& found);

/// What pulls at the tool hard may look like a sensor that is turned or a sign mixed up: where causes explain more
/// without a mistake, there is none, and `readings` and `found` are those without it.
void unlessCausesExplainMore(const Recording& recording, const RobotModel* robot, DiagnoseOptions options,
                             const Progress& progress, Readings& readings, SearchedInParts& found);

}  // namespace heft::diagnosis
