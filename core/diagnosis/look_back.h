#pragma once
// Each accepted cause once more, against everything that could stand in its place.
#include <string_view>

#include "core/diagnosis/search.h"

namespace heft::diagnosis {

constexpr double kBesideWandering =
    30.0;  ///< More evidence: what a few slow waves leave of a wandering zero is no cause
/// By how much a jump must be more than a walk of the zero: one that walks makes steps, too. Of 60 zeros that walked,
/// a jump was 21 less in the nearest; of 21 plain jumps it was 8 more in the nearest, of three faint ones 8 to 16 less.
constexpr double kJump = 5.0;

constexpr double kOfOneCourse = 0.5;  ///< Share of what the walk explains that a drift in its place must

/// Readings late or smoothed, or the recorded motion.
bool lags(std::string_view cause);

/// Makes fast forces larger than the motion says.
bool enlarges(std::string_view cause);

/// Whether a cause that goes on all the time and is no drift explains so much of what a walk of the zero does that it
/// is named instead. In 98 recordings whose zero walked, none came to half of it.
bool isMoreThanWalk(std::string_view cause, double gain, double walk);

/// Fills `search.found`; where something else is better, it takes a cause's place in `search.final`. Whether anything
/// did.
bool lookBack(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
              const SearchOptions& options, Search& search, const Progress& progress);

}  // namespace heft::diagnosis
