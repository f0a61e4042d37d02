#pragma once
// What a diagnosis is asked for.
#include <optional>
#include <string>
#include <vector>

#include "core/estimation/estimate.h"

namespace heft {

struct DiagnoseOptions {
  std::optional<SegmentMode> segments;  ///< Marks where there are any, otherwise contact is found like other causes.
  int surrogates = 200;                 ///< Simulated clean recordings that set the threshold; 0: a fixed one.
  unsigned seed = 1;
  std::vector<std::string> hidden;  ///< Causes not to be looked for, by ID: shows what a missing cause looks like.
  EstimateOptions estimate;         ///< How the payload is estimated, before and after.
};

}  // namespace heft
