#pragma once
// Each accepted cause once more, against everything that could stand in its place.
#include "core/diagnosis/search/search.h"

namespace heft::diagnosis {

/// Fills `search.found`; where something else is better, it takes a cause's place in `search.final`. Whether anything
/// did.
bool compareRivals(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
                   const SearchOptions& options, Search& search, const Progress& progress);

}  // namespace heft::diagnosis
